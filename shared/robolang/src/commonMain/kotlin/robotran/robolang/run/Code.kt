package robotran.robolang.run

import robotran.robolang.syntax.Routine

/**
 * A program as one list of instructions, made by [lower] and shared by all runs.
 *
 * @property name the program's name.
 * @property main the index of the main program's first instruction.
 * @property globals the number of slots for the variables of the main program and the behaviours.
 * @property firstLine the line of the first statement; 0 if there is none.
 */
internal class Code(
    val name: String,
    val instructions: List<StackInstruction>,
    val main: Int,
    val globals: Int,
    val behaviours: List<BehaviourCode>,
    val firstLine: Int,
)

/** A routine as instructions. Its frame has [slots], one per variable, parameters first. */
internal class RoutineCode(routine: Routine, val slots: Int) {
    val name = routine.name.text
    val parameters = routine.parameters.size

    /** The index of its first instruction, set when it is lowered. */
    var entry = 0
}

/**
 * A behaviour as instructions.
 *
 * @property condition the index of its condition, which leaves 1 or 0 on the stack.
 * @property action the index of its action.
 * @property line the line of its `whenever`.
 */
internal class BehaviourCode(val condition: Int, val action: Int, val line: Int)
