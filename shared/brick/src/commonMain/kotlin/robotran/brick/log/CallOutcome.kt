package robotran.brick.log

/** The result of a call of the brick's firmware or ROM. */
enum class CallOutcome {
    /** The virtual brick did it. */
    DONE,

    /** A wrong code or too few arguments. A real brick would do nothing either, or something unpredictable. */
    WRONG_ARGUMENTS,

    /** Something that a real brick does and the virtual brick does not implement; nothing happened. */
    NOT_MODELLED,

    /** No known routine of an RCX starts at this address; a real brick would probably crash. */
    UNKNOWN_ROUTINE,
}
