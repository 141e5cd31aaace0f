package robotran.robolang.nqc

import robotran.robolang.RobolangProgram
import robotran.robolang.check.ValueType
import robotran.robolang.robot.RobotTarget
import robotran.robolang.robot.SensorPorts
import robotran.robolang.run.RobotConstants
import robotran.robolang.run.mayTurnAtEnd
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.allStatements
import robotran.robolang.translate.CommentsOfItems
import robotran.robolang.translate.JavaFlow
import robotran.robolang.translate.JavaWriter
import robotran.robolang.translate.SourceLines

/** Assembles a translation: figures, global variables, functions, the main task. */
internal class NqcFile(
    private val program: RobolangProgram,
    private val robot: RobotTarget.Rcx,
    private val notes: TranslationNotes,
) {
    private val checked = program.checked
    private val tree = checked.tree
    private val ports = SensorPorts(tree, robot.kind)
    private val names = NqcNames()
    private val helpers = UsedNqcHelpers(robot)
    private val comments = CommentsOfItems(tree)
    private val body = JavaWriter(sourceLines = SourceLines(tree))
    private val recursive = RecursiveRoutines(checked)
    private val lists = KnownLists(checked)
    private val expressions = NqcExpressions(checked, names, ports.lightPort, recursive, lists, notes)
    private val statements = NqcStatements(checked, names, expressions, helpers, recursive, lists, notes, body)

    fun write(): JavaWriter {
        val declarations = tree.statements.filterIsInstance<Statement.Declare>().filter { isGlobal(it) }
        val globals = declarations.map { checked.symbolOf(it.name) }.distinct()
        (globals + tree.routines.map { checked.symbolOf(it.name) }).distinct().forEach { names.declareShared(it) }
        val isShown = { type: ValueType -> type != ValueType.DECIMAL && !type.isList }
        for (global in globals) {
            val size = lists.sizeOf(global)
            if (size != null) body.line("int ${names.of(global)}[$size];")
            if (isShown(global.type)) body.line("int ${names.of(global)};")
        }
        tree.routines.forEach { routine(it) }
        tree.behaviours.forEach { body.line("// ${notes.lost(it.range, notes.messages.whenever())}") }
        main()
        return whole()
    }

    private fun isGlobal(declaration: Statement.Declare) = checked.symbolOf(declaration.name).isGlobal

    private fun routine(routine: Routine) {
        body.blank()
        body.takeComments(comments.of(routine.range))
        val symbol = checked.symbolOf(routine.name)
        if (routine in recursive) {
            body.line("// ${notes.lost(routine.name.range, notes.messages.recursion(routine.name.text))}")
            return
        }
        if (routine.isFunction && (symbol.type == ValueType.DECIMAL || symbol.type.isList)) {
            body.line("// ${notes.lost(routine.name.range, notes.messages.decimal())}")
        }
        names.inScope {
            val result = if (routine.isFunction) names.local("result") else null
            val parameters = routine.parameters.map { "int ${names.declareLocal(checked.symbolOf(it))}" }
            val all = listOfNotNull(result?.let { "int &$it" }) + parameters
            body.open("void ${names.of(symbol)}(${all.joinToString()})", routine.range.line)
            statements.inRoutine(result) { statements.block(routine.body) }
            body.commentsAbove(routine.endRange.line)
            body.close(routine.endRange.line)
        }
    }

    private fun main() {
        body.blank()
        body.open("task main()")
        // Written to its own place only when it is known what is used.
        val commands = JavaWriter(depth = 1, SourceLines(tree))
        names.inScope {
            statements.into(commands) {
                statements.write(tree.statements) { commands.takeComments(comments.of(it.range)) }
            }
        }
        commands.takeComments(comments.closing)
        commands.commentsLeft()
        tree.robot?.let { body.takeComments(comments.of(it.range)) }
        setUp()
        tree.robot?.let { body.commentsAbove(it.endRange.line + 1) }
        body.append(commands)
        // At the end of a program, leJOS brakes all motors, but LEGO's firmware does not.
        val isEndReached = JavaFlow(checked).completes(tree.statements)
        if (isEndReached && mayTurnAtEnd(tree)) body.line("Off(OUT_A + OUT_B + OUT_C);")
        body.close()
    }

    /** Sensors and motors as they are when a program in Robolang begins. */
    private fun setUp() {
        ports.bumpers.forEach { body.line("SetSensor(SENSOR_${it.port}, SENSOR_TOUCH);") }
        if (ports.usesLight) body.line("SetSensor(SENSOR_${ports.lightPort}, SENSOR_LIGHT);", ports.lightLine)
        if (allStatements(tree).any { it.usesMotor }) {
            body.line("SetPower(OUT_A + OUT_B + OUT_C, ${RobotConstants.DRIVING_POWER});")
        }
    }

    private val Statement.usesMotor: Boolean
        get() = this is Command && moves && this !is Command.MotorTurn

    private fun whole(): JavaWriter = JavaWriter().apply {
        val name = program.name.lines().joinToString(" ").replace('\\', '/')
        line("// $name, translated by Robotran to NQC for the RCX with LEGO's firmware 2.0.")
        line("// The brick computes with whole numbers from -32768 to 32767.")
        blank()
        takeComments(comments.heading)
        commentsLeft()
        helpers.write(this)
        append(body)
    }
}
