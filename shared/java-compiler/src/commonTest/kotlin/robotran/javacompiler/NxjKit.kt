package robotran.javacompiler

import robotran.javacompiler.ecj.BrickTarget
import robotran.language.source.Diagnostic
import robotran.languagesupport.SourceFile
import robotran.nxjlibrary.NxjLibrary
import kotlin.test.assertIs
import kotlin.test.fail

/** Compiles [text] as `Robot.java` for an NXT, with all that leJOS NXJ has, and if it [isForgiving] with more. */
suspend fun compileForNxt(text: String, isForgiving: Boolean = false): CompilationResult {
    val library = NxjLibrary.load()
    return compiler().compile(
        listOf(SourceFile("Robot.java", text)),
        if (isForgiving) library.classFiles else library.classFilesOfBrick,
        target = BrickTarget.LEJOS_NXJ,
    )
}

suspend fun compiledForNxt(text: String): CompilationResult.Success = when (val result = compileForNxt(text)) {
    is CompilationResult.Success -> result
    is CompilationResult.Failure -> fail(result.diagnostics.joinToString("\n") { "${it.range?.line}: ${it.message}" })
}

/** A whole program for an NXT with [statements], which begin in line 8. */
fun nxtProgram(statements: String) =
    "import java.util.*;\nimport lejos.nxt.*;\nimport lejos.util.*;\nimport lejos.robotics.*;\n" +
        "import lejos.robotics.navigation.*;\npublic class Robot {\n" +
        "public static void main(String[] args) throws Exception {\n$statements\n}\n}\n"

/** The first diagnostic of the program [text] for an NXT. */
suspend fun nxtDiagnosticOf(text: String): Diagnostic =
    assertIs<CompilationResult.Failure>(compileForNxt(text), text).diagnostics.first()

/** The first diagnostic for [statements] in a main method for an NXT. */
suspend fun nxtDiagnostic(statements: String): Diagnostic = nxtDiagnosticOf(nxtProgram(statements))
