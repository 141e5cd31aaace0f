package robotran.nqc.tree

import robotran.language.source.SourceRange

/**
 * A variable or a parameter; every declaration is another one.
 *
 * @property size in elements; 1 unless it is an array.
 * @property parameter what kind of parameter it is; null for a variable.
 */
internal class Variable(
    val name: String,
    val range: SourceRange,
    val isGlobal: Boolean = false,
    val isArray: Boolean = false,
    val isPointer: Boolean = false,
    val size: Int = 1,
    val parameter: ParameterKind? = null,
) {
    /** Whether it may be the target of an assignment. */
    val isAssignable: Boolean get() = parameter?.isAssignable ?: true
}

/** How a function takes an argument, and whether it can be assigned to. */
internal enum class ParameterKind(val text: String, val isAssignable: Boolean) {
    /** `int v`: a variable of the function. */
    VALUE("int", true),

    /** `int &v`: the variable of the call. */
    REFERENCE("int &", true),

    /** `const int v`: a constant. */
    CONSTANT("const int", false),

    /** `const int &v`: the expression of the call, again at each use. */
    EXPRESSION("const int &", false),

    /** `__sensor s`: a sensor. */
    SENSOR("__sensor", false),

    /** `int *p`. */
    POINTER("int *", true),

    /** `const int *p`: the function has its own copy of the pointer. */
    CONSTANT_POINTER("const int *", false),
}
