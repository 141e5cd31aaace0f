package robotran.robolang.python.writer

import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.Statement

/** How numbers and lists of a robot's Python become those of Robolang, or nearly. */
internal interface PythonArithmetic {
    /** [number], which stands for [expression]. */
    fun checked(number: Long, expression: Expression): String

    /** [text], which is [expression]: a sum, a difference, a product or an opposite of whole numbers. */
    fun whole(text: PythonText, expression: Expression): PythonText = text

    fun quotient(expression: Expression.Binary): PythonText

    fun remainder(expression: Expression.Binary): PythonText

    fun element(expression: Expression.ListElement): PythonText

    /** The line that gives the element at [index] of [list] a [value]. */
    fun setElement(list: Name, index: Expression, value: String): String

    /** A random number; Robolang takes the two limits in either order. */
    fun random(call: Expression.Call): PythonText

    /** A square root or a power, with its [arguments] written. */
    fun rootOrPower(builtIn: BuiltIn, call: Expression.Call, arguments: String): PythonText

    /** What a loop goes over that does something [Statement.Repeat.count] times. */
    fun times(loop: Statement.Repeat): String

    /** The numbers of a loop with a step that is not known; [arguments] are the first, the last and the step. */
    fun count(loop: Statement.ForRange, arguments: String): String

    /** The [step] of a loop over decimal numbers, which is not known. */
    fun step(loop: Statement.ForRange, step: String): String = step
}
