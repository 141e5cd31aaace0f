package robotran.nqc.syntax

/**
 * The words of the language that are no names.
 *
 * @property group for completion.
 */
internal enum class Keyword(val group: KeywordGroup, word: String? = null) {
    ABS(KeywordGroup.VALUE),
    ACQUIRE(KeywordGroup.STATEMENT),
    ASM(KeywordGroup.STATEMENT),
    BREAK(KeywordGroup.STATEMENT),
    CASE(KeywordGroup.STATEMENT),
    CATCH(KeywordGroup.STATEMENT),
    CONST(KeywordGroup.OTHER),
    CONTINUE(KeywordGroup.STATEMENT),
    DEFAULT(KeywordGroup.STATEMENT),
    DO(KeywordGroup.STATEMENT),
    ELSE(KeywordGroup.STATEMENT),
    FALSE(KeywordGroup.VALUE),
    FOR(KeywordGroup.STATEMENT),
    GOTO(KeywordGroup.STATEMENT),
    IF(KeywordGroup.STATEMENT),
    INT(KeywordGroup.DECLARATION),
    MONITOR(KeywordGroup.STATEMENT),
    REPEAT(KeywordGroup.STATEMENT),
    RETURN(KeywordGroup.STATEMENT),
    SIGN(KeywordGroup.VALUE),
    START(KeywordGroup.STATEMENT),
    STOP(KeywordGroup.STATEMENT),
    SUB(KeywordGroup.UNIT),
    SWITCH(KeywordGroup.STATEMENT),
    TASK(KeywordGroup.UNIT),
    TRUE(KeywordGroup.VALUE),
    VOID(KeywordGroup.UNIT),
    WHILE(KeywordGroup.STATEMENT),
    EVENT_SOURCE(KeywordGroup.INTERNAL, "__event_src"),
    NO_LISTING(KeywordGroup.INTERNAL, "__nolist"),
    RESOURCE(KeywordGroup.INTERNAL, "__res"),
    SENSOR(KeywordGroup.INTERNAL, "__sensor"),
    TASK_NUMBER(KeywordGroup.INTERNAL, "__taskid"),
    TYPE(KeywordGroup.INTERNAL, "__type"),
    ;

    val text: String = word ?: name.lowercase()

    companion object {
        private val byText = entries.associateBy { it.text }

        fun of(text: String): Keyword? = byText[text]
    }
}

internal enum class KeywordGroup {
    /** Begins a task, subroutine or function. */
    UNIT,

    /** Begins a declaration, within a task or outside. */
    DECLARATION,
    STATEMENT,
    VALUE,
    OTHER,

    /** Not meant for pupils. */
    INTERNAL,
}
