package robotran.tinyvm.messages

/** What a program can have too many of. */
enum class Counted {
    CLASSES,
    ARRAY_TYPES,
    FIELDS,
    METHODS,
    LOCALS,
    OPERANDS,
    PARAMETERS,
    HANDLERS,
    CODE_BYTES,
    TEXT_CHARACTERS,
    ANCESTORS,
}
