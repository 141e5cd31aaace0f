package robotran.robolang.run

import robotran.brick.kind.BrickKind
import robotran.robolang.check.CheckedProgram
import robotran.robolang.syntax.Behaviour
import robotran.robolang.syntax.Routine
import robotran.robolang.words.BrickDialect

/**
 * Lowers a program to instructions: first the set-up of its sensors, then the main program, the routines and the
 * behaviours.
 *
 * Every statement and every further round of a loop begins with a [Boundary.Statement]. Every cycle in the code passes
 * one, so no code between two of them runs for ever. A run can therefore be stopped at any statement, and only there or
 * while it waits. Budgets, behaviours and debugging rely on this.
 */
internal fun lower(program: CheckedProgram, name: String, kind: BrickKind): Code {
    val emitter = Emitter()
    val scope = LoweringScope(program, kind)
    val statements = StatementLowering(emitter, scope)
    val main = emitter.place
    emitter.emit { activity -> activity.machine.run { robot.setUp(scope.ports) { setUpLine = it } } }
    if (BrickDialect.of(kind).waitsForSensors) emitter.emit { if (!it.machine.robot.isSetUp) it.lookAgain() }
    statements.lowerMain(program.tree)
    emitter.emit(Boundary.End)
    program.tree.routines.forEach { lowerRoutine(it, scope.codeOf(it.name), emitter, statements) }
    val behaviours = program.tree.behaviours.map { lowerBehaviour(it, emitter, statements) }
    return Code(
        name = name,
        instructions = emitter.instructions,
        main = main,
        globals = program.slotsOf(null),
        behaviours = behaviours,
        firstLine = program.tree.statements.firstOrNull()?.range?.line ?: 0,
    )
}

private fun lowerRoutine(routine: Routine, code: RoutineCode, emitter: Emitter, statements: StatementLowering) {
    code.entry = emitter.place
    statements.lowerRoutine(routine)
    if (routine.isFunction) {
        emitter.emit { fail(it.machine.messages.nothingReturned(code.name)) }
    } else {
        emitter.emit { it.leave() }
    }
}

private fun lowerBehaviour(behaviour: Behaviour, emitter: Emitter, statements: StatementLowering): BehaviourCode {
    val condition = emitter.place
    statements.expressions.lower(behaviour.condition)
    emitter.emit(Boundary.End)
    val action = emitter.place
    emitter.statement(behaviour.range.line)
    statements.lowerBody(behaviour.body)
    emitter.emit(Boundary.End)
    return BehaviourCode(condition, action, behaviour.range.line)
}
