package robotran.programs

import kotlinx.coroutines.test.runTest
import robotran.tinyvm.config.TinyVmMode
import kotlin.test.Test
import kotlin.time.measureTime

class LinkTimeTest {
    @Test
    fun measure() = runTest {
        val brick = ProgramCompiler(testCalibration)
        val forgiving = ProgramCompiler(testCalibration, JavaSettings(TinyVmMode.FORGIVING))
        for (round in 1..4) {
            for (compiler in listOf(brick, forgiving)) {
                val time = measureTime {
                    repeat(5) {
                        for ((name, text) in lejosExamples) {
                            compiler.read(
                                ProgramSource.Java(name, listOf(SourceFile(name, text))),
                            )
                        }
                    }
                }
                println("MEASURED $round ${compiler === brick} ${time / (5 * lejosExamples.size)}")
            }
        }
    }
}
