package robotran.robolang.run

import robotran.brick.kind.BrickKind
import robotran.robolang.check.CheckedProgram
import robotran.robolang.check.Symbol
import robotran.robolang.check.ValueType
import robotran.robolang.robot.SensorPorts
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.NumberValue
import robotran.robolang.words.BrickDialect

/** The types and symbols that lowering needs. */
internal class LoweringScope(private val program: CheckedProgram, val kind: BrickKind) {
    private val routines: List<RoutineCode> = program.tree.routines.map { RoutineCode(it, program.slotsOf(it)) }

    val ports = SensorPorts(program.tree, kind)

    /** Whether whole numbers have 31 bits. */
    val hasShortNumbers = BrickDialect.of(kind).hasShortNumbers

    /** Whether the wheels are stopped before the program ends. */
    val stopsAtEnd = stopsAtEnd(program.tree, kind)

    private val byName = program.tree.routines.map { it.name.key }.zip(routines).toMap()

    fun codeOf(name: Name): RoutineCode = byName.getValue(name.key)

    /** The parameter types of the routine [name], in order. */
    fun parametersOf(name: Name): List<ValueType> = codeOf(name).let { code -> parameterTypes.getValue(code) }

    fun symbolOf(name: Name): Symbol = program.symbolOf(name)

    fun typeOf(expression: Expression): ValueType = when (expression) {
        is Expression.Number -> if (expression.value is NumberValue.Whole) ValueType.WHOLE else ValueType.DECIMAL
        is Expression.BooleanLiteral -> ValueType.TRUTH
        is Expression.ColourLiteral -> ValueType.COLOUR
        is Expression.Brackets -> typeOf(expression.inner)
        else -> program.typeOf(expression)
    }

    fun arithmeticOf(type: ValueType): Arithmetic = Arithmetic.of(type, hasShortNumbers)

    private val parameterTypes: Map<RoutineCode, List<ValueType>> =
        routines.zip(program.tree.routines) { code, routine ->
            code to
                routine.parameters.map { program.symbolOf(it).type }
        }.toMap()
}
