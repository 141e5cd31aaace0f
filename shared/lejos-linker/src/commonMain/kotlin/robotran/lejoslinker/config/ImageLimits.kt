package robotran.lejoslinker.config

import robotran.tinyvm.config.TinyVmLimits

/**
 * What fits into an image. Source, unless stated: leJOS `TinyVMConstants`, `ClassRecord`, `MethodRecord` and
 * `CodeUtilities`. Limits marked so are not checked by leJOS's linker, which makes a wrong image instead.
 */
object ImageLimits {
    /** Max offset of anything in the image, which has 16 bits. */
    const val IMAGE_OFFSET = 0xFFFF

    /** Max classes; their numbers have 8 bits. Not checked by leJOS. */
    const val CLASSES = 256

    /** Max classes that can be started; their number has 8 bits. */
    const val ENTRY_CLASSES = 255

    /** Max number of a constant in `ldc`, which has 8 bits. Not checked by leJOS. */
    const val LOADED_CONSTANT = 255

    /** Max number of a static field that code can reach, which has 8 bits. Not checked by leJOS. */
    const val STATIC_FIELD = 255

    /** Max offset of a field in the static state or in an object, which has 12 bits. Not checked by leJOS. */
    const val OFFSET = 0xFFF

    /** Max signatures; their numbers have 12 bits. */
    const val SIGNATURES = 4096

    const val FIELDS = TinyVmLimits.FIELDS
    const val METHODS = TinyVmLimits.METHODS
    const val LOCALS = TinyVmLimits.LOCALS
    const val OPERANDS = TinyVmLimits.OPERANDS
    const val HANDLERS = TinyVmLimits.EXCEPTION_HANDLERS

    /** Max words of a method's parameters, with `this`. */
    const val PARAMETER_WORDS = TinyVmLimits.PARAMETERS

    /** Max characters of a text, whose length has 8 bits. Not checked by leJOS. */
    const val TEXT_CHARACTERS = TinyVmLimits.STRING_CHARACTERS

    /** The firmware makes one char of each byte of a text. Not checked by leJOS. */
    const val CHARACTER = 0xFF
}
