package robotran.robolang.run

import robotran.robolang.syntax.Routine

/**
 * A program as instructions, all in one list; made once, by [lower], and shared by all runs.
 *
 * @property name the program's.
 * @property main where the main program begins.
 * @property globals how many slots the variables of the main program and the behaviours take.
 * @property firstLine the line of the first statement, 0 if there is none.
 */
internal class Code(
    val name: String,
    val instructions: List<StackInstruction>,
    val main: Int,
    val globals: Int,
    val behaviours: List<BehaviourCode>,
    val firstLine: Int,
)

/** A routine as instructions; its frame has [slots], one for each variable, the parameters being first. */
internal class RoutineCode(routine: Routine, val slots: Int) {
    val name = routine.name.text
    val parameters = routine.parameters.size

    /** Where it begins; known once it is lowered. */
    var entry = 0
}

/**
 * A behaviour as instructions.
 *
 * @property condition where its condition begins, which leaves 1 or 0 on the stack.
 * @property action where what it does begins.
 * @property line the line of its `whenever`.
 */
internal class BehaviourCode(val condition: Int, val action: Int, val line: Int)
