package robotran.javacompiler.messages

/** Java features that are newer than the brick's Java. */
enum class NewerJava {
    GENERICS,
    FOR_EACH,
    VARARGS,
    ANNOTATION,
    ENUM,
    STATIC_IMPORT,
    INTERFACE_METHOD_BODY,
    LAMBDA,
    MULTI_CATCH,
    TRY_WITH_RESOURCES,
    SWITCH_EXPRESSION,
    AUTOBOXING,

    /** Type arguments that the compiler finds out by itself: `<>`. */
    DIAMOND,
    TEXT_IN_SWITCH,
    ASSERT,
    VAR,
    TEXT_BLOCK,

    /** Underscores and binary digits. */
    NUMBER_STYLE,
}
