package robotran.robolang.translate

import robotran.robolang.RobolangProgram
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.documentedPrograms
import robotran.robolang.examplePrograms
import robotran.robolang.testCalibration
import robotran.robolang.testPrograms

/** Every program without mistakes among the tests, the examples and those of the documents, by path. */
internal val translatablePrograms: Map<String, RobolangProgram> by lazy {
    (testPrograms + documentedPrograms + examplePrograms).mapNotNull { (path, text) ->
        (compileRobolang(path, text, testCalibration) as? RobolangResult.Ready)?.let { path to it.program }
    }.toMap()
}

/** [source] in Java, as a program called [name]. */
internal fun translationOf(source: String, name: String = "test.robo"): Translation =
    when (val result = compileRobolang(name, source, testCalibration)) {
        is RobolangResult.Ready -> translateRobolang(result.program)
        is RobolangResult.HasErrors -> throw AssertionError(result.diagnostics.joinToString("\n") { it.message })
    }

/** The lines of [source] in Java, without their indentation. */
internal fun javaLinesOf(source: String): List<String> = translationOf(source).java.lines().map { it.trim() }
