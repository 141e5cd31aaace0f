package robotran.robolang.python.writer

import robotran.language.source.SourceRange
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.Token

/** The parts of a program that its main program is put together from. */
internal interface PythonParts {
    /** The statements of the main program that do not stand above the functions. */
    val statements: List<Statement>

    /** Comments below the last statement. */
    val closing: List<Token>

    val variables: SharedVariables

    fun commentsOf(range: SourceRange): List<Token>

    /** What writes statements of [place] to [writer]. */
    fun statements(writer: PythonWriter, place: PythonPlace): PythonStatements

    /** Writes [part], statements of the main program outside of tasks. */
    fun write(part: List<Statement>, writer: PythonWriter)

    /** Writes which variables of the whole program the lines of [body] change. */
    fun globals(body: List<Statement>, writer: PythonWriter)

    /** The same for a main program that is a function. */
    fun globalsOfMain(writer: PythonWriter)

    /** Declares the variables of a main program that is a function which others use. */
    fun declareShared(writer: PythonWriter)
}
