package robotran.robolang.python.writer

import robotran.robolang.check.ValueType
import robotran.robolang.syntax.Statement

/** What a statement belongs to. */
internal interface PythonPlace {
    /** The type of what a function gives back; null elsewhere. */
    val result: ValueType? get() = null

    /** The lines before [statement]. */
    fun linesBefore(statement: Statement): List<String> = emptyList()

    /** The main program, or a routine: nothing stands before a statement. */
    class Plain(override val result: ValueType? = null) : PythonPlace
}
