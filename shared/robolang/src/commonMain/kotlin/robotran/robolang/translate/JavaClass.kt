package robotran.robolang.translate

import robotran.robolang.RobolangProgram
import robotran.robolang.robot.SensorPorts
import robotran.robolang.run.NxtConstants
import robotran.robolang.run.stopsAtEnd
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.Statement

/** Assembles the class of a program: figures, fields, `main`, routines, behaviours, helpers. */
internal class JavaClass(private val program: RobolangProgram, private val className: String) {
    private val checked = program.checked
    private val tree = checked.tree
    private val robot = program.robot
    private val dialect = JavaDialect.of(robot)
    private val sensors = dialect.sensors(SensorPorts(tree, robot.kind))
    private val names = JavaNames(className, dialect.platform)
    private val helpers = UsedHelpers(dialect, isReacting = tree.behaviours.isNotEmpty())
    private val comments = CommentsOfItems(tree)
    private val throwing = Throwing(checked, dialect.waitsForStop, stopsAtEnd(tree, robot.kind))
    private val expressions = JavaExpressions(checked, names, helpers, sensors)
    private val nxtCommands = dialect.commands(expressions, helpers)
    private val stopsAtEnd = stopsAtEnd(tree, robot.kind)
    private val body = JavaWriter(depth = 1, SourceLines(tree))
    private val texts = JavaShownTexts(tree, names)
    private val statements = JavaStatements(checked, names, expressions, helpers, texts, nxtCommands, stopsAtEnd, body)
    private val fields = JavaFields(checked, names, expressions, comments)
    private val behaviours =
        JavaBehaviours(checked, names, expressions, throwing, comments, statements, body, robot.kind)

    fun write(): JavaWriter {
        behaviours.reserveNames()
        val globals = tree.statements.filterIsInstance<Statement.Declare>().map { it.name }
        (globals + tree.routines.map { it.name }).map(checked::symbolOf).distinct().forEach(names::declareShared)
        if (sensors.areFields) {
            tree.robot?.let { body.takeComments(comments.of(it.range)) }
            tree.robot?.let { body.commentsAbove(it.range.line + 1) }
            sensors.write(body)
            tree.robot?.let { body.commentsAbove(it.endRange.line + 1) }
        }
        fields.write(body)
        if (dialect.keepsTexts) texts.write(body)
        main()
        tree.routines.forEach(::routine)
        behaviours.writeClasses()
        // Written first: only then is it known which helpers are used.
        return whole()
    }

    private fun main() {
        body.blank()
        val throws =
            throwsClause(helpers.isReacting || sensors.hasLamp || throwing.mayWait(tree.statements))
        body.open("public static void main(String[] arguments)$throws")
        if (!sensors.areFields) {
            tree.robot?.let { body.takeComments(comments.of(it.range)) }
            sensors.write(body)
            tree.robot?.let { body.commentsAbove(it.endRange.line + 1) }
        }
        if (sensors.hasLamp) {
            body.line("Thread.sleep(${NxtConstants.LAMP_MILLISECONDS}); // Until it has measured with its lamp on.")
        }
        body.blank()
        mainStatements()
        body.close()
    }

    private fun mainStatements() {
        val declarations = tree.statements.takeWhile { it is Statement.Declare }
        names.inScope {
            mainStatements(declarations)
            if (helpers.isReacting) behaviours.writeStart()
            mainStatements(tree.statements.drop(declarations.size))
        }
        body.takeComments(comments.closing)
        body.commentsLeft()
        val isEndReached = tree.behaviours.isEmpty() && JavaFlow(checked).completes(tree.statements)
        if (stopsAtEnd && isEndReached &&
            tree.statements.last() !is Statement.Halt
        ) {
            body.line("${helpers.use(JavaHelper.PILOT_FIELD)}.stop();")
        }
    }

    private fun mainStatements(part: List<Statement>) =
        statements.write(part.filterNot(fields::isField)) { body.takeComments(comments.of(it.range)) }

    private fun routine(routine: Routine) {
        val symbol = checked.symbolOf(routine.name)
        body.blank()
        body.takeComments(comments.of(routine.range))
        names.inScope {
            val parameters = routine.parameters.joinToString(", ") { name ->
                val parameter = checked.symbolOf(name)
                "${javaType(parameter.type)} ${names.declareLocal(parameter)}"
            }
            val type = if (routine.isFunction) javaType(symbol.type) else "void"
            val head = "static $type ${names.of(symbol)}($parameters)${throwsClause(throwing.mayWait(routine))}"
            val notes = (listOf(symbol) + routine.parameters.map(checked::symbolOf)).mapNotNull(names::noteOn)
            body.open(head, routine.range.line, notes.joinToString(", ").ifEmpty { null })
            statements.block(routine.body)
            body.commentsAbove(routine.endRange.line)
            if (routine.isFunction && JavaFlow(checked).completes(routine.body)) {
                body.line("return ${statements.defaultOf(symbol.type)};", routine.endRange.line)
            }
            body.close(routine.endRange.line)
        }
    }

    private fun whole(): JavaWriter = JavaWriter().apply {
        val name = program.name.lines().joinToString(" ").replace('\\', '/')
        dialect.heading(this, name, tree)
        if (JavaHelper.DICE in helpers.all) line("import java.util.*;")
        blank()
        takeComments(comments.heading)
        commentsLeft()
        open("public class $className")
        helpers.all.filter { it.isField }.forEach { helper(it) }
        append(body)
        val methods = helpers.all.filterNot { it.isField }
        if (methods.isNotEmpty()) {
            blank()
            line(METHODS_BELOW)
        }
        val (calculations, others) = methods.partition { it.isCalculation }
        others.forEach { helper(it) }
        if (calculations.isNotEmpty()) {
            blank()
            line(CALCULATION_ABOVE)
            open("static class ${JavaHelper.CALCULATION}")
            calculations.forEach { helper(it) }
            close()
        }
        close()
    }

    private fun JavaWriter.helper(helper: JavaHelper) {
        blank()
        lines(helpers.textOf(helper))
    }
}

/** The end of the pupil's own part. */
internal const val METHODS_BELOW = "// The methods below do what the commands of Robolang do."

private const val CALCULATION_ABOVE =
    "/** Calculates with decimal numbers as Robotran does. A class of its own, for a class has room for few numbers " +
        "on a brick. */"

/** The `throws` clause of a method, if it [mayWait]. */
internal fun throwsClause(mayWait: Boolean): String = if (mayWait) " throws InterruptedException" else ""
