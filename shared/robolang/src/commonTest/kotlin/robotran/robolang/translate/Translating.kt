package robotran.robolang.translate

import robotran.robolang.RobolangProgram
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.documentedPrograms
import robotran.robolang.examplePrograms
import robotran.robolang.testCalibration
import robotran.robolang.testPrograms

/** All valid programs of the tests, the examples and the documents, by path. */
internal val translatablePrograms: Map<String, RobolangProgram> by lazy {
    (testPrograms + documentedPrograms + examplePrograms).mapNotNull { (path, text) ->
        (compileRobolang(path, text, testCalibration) as? RobolangResult.Ready)?.let { path to it.program }
    }.toMap()
}

/** Translates [source], named [name], to Java. */
internal fun translationOf(source: String, name: String = "test.robo"): Translation =
    when (val result = compileRobolang(name, source, testCalibration)) {
        is RobolangResult.Ready -> translateRobolang(result.program)
        is RobolangResult.HasErrors -> throw AssertionError(result.diagnostics.joinToString("\n") { it.message })
    }

/** The lines of the translation of [source], without indentation. */
internal fun javaLinesOf(source: String): List<String> = translationOf(source).java.lines().map { it.trim() }
