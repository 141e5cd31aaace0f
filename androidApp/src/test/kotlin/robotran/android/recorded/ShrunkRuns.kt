package robotran.android.recorded

import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.robolang.robot.RobotTarget
import robotran.world.Penbot
import java.io.File
import kotlin.system.exitProcess

/**
 * Compares the app's classes after R8 with the recorded runs, on a plain JVM, and checks that the Java compiler still
 * has its error messages. The only argument is the folder with the source tree.
 */
fun main(arguments: Array<String>) = runBlocking {
    val outcome = RecordedRuns(File(arguments.single())).differences()
    val faults = outcome.differences + mistakeFaults()
    faults.forEach(System.err::println)
    if (outcome.robolang == 0 || outcome.java == 0 || outcome.projects == 0) exitProcess(2)
    if (faults.isNotEmpty()) exitProcess(1)
    val examples = "${outcome.robolang} Robolang examples, ${outcome.java} Java examples"
    println("$examples and ${outcome.projects} projects make their recorded runs")
}

private suspend fun mistakeFaults(): List<String> {
    val compiler =
        ProgramCompiler(
            RobotTarget.Rcx(Penbot.MILLISECONDS_PER_CENTIMETRE, Penbot.MILLISECONDS_PER_DEGREE),
            language = Language.ENGLISH,
        )
    val text = "public class Oops {\n  public static void main(String[] words) {\n    int count = \"five\";\n  }\n}\n"
    val result = compiler.compileOrThrow(Program("Oops.java", ProgramLanguage.JAVA, text))
    val diagnostic = (result as? ProgramResult.Failure)?.diagnostics?.singleOrNull()
    val isReported = diagnostic != null && ("count" in diagnostic.message || "String" in diagnostic.message)
    return if (isReported) emptyList() else listOf("One mistake was to be told in words, and not $result")
}
