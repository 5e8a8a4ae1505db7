/* The page as it is, a megabyte that no compiler has to read. */
        .section .rodata
        .global animado_page_begin
        .global animado_page_end
animado_page_begin:
        .incbin ANIMADO_PAGE
animado_page_end:
        .section .note.GNU-stack, "", @progbits
