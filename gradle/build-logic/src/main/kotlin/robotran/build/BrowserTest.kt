package robotran.build

import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.InputFiles
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.process.ExecOperations
import java.io.File
import javax.inject.Inject

/** Runs the `*.test.mjs` among [tests] with Node's own test runner. */
@CacheableTask
abstract class BrowserTest
    @Inject
    constructor(processes: ExecOperations) : BrowserTask(processes) {
        @get:InputFiles
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val tests: ConfigurableFileCollection

        /** The programs that the page runs; in [expectedRuns] and, for Java, [expectedJavaRuns] the report and the ROM log that each must leave. */
        @get:InputFiles
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val examples: ConfigurableFileCollection

        @get:InputDirectory
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val expectedRuns: DirectoryProperty

        @get:InputDirectory
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val expectedJavaRuns: DirectoryProperty

        /** Projects that the page runs, each with the report that it must leave. */
        @get:InputDirectory
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val expectedProjectRuns: DirectoryProperty

        /** What the tests photograph. */
        @get:OutputDirectory
        abstract val pictures: DirectoryProperty

        /** The results as JUnit's XML. */
        @get:OutputDirectory
        abstract val results: DirectoryProperty

        @TaskAction
        fun test() {
            val runner = listOf(
                "--test", "--test-concurrency=1", "--test-reporter=spec", "--test-reporter-destination=stdout",
                "--test-reporter=junit", "--test-reporter-destination=${results.file("TEST-browser.xml").get().asFile}",
            )
            runNode(runner + tests.files.filter { it.name.endsWith(".test.mjs") }.map { it.path }.sorted()) { exec ->
                exec.environment("EXAMPLES", examples.files.joinToString(File.pathSeparator) { it.path })
                exec.environment("EXPECTED_RUNS", expectedRuns.get().asFile.path)
                exec.environment("EXPECTED_JAVA_RUNS", expectedJavaRuns.get().asFile.path)
                exec.environment("EXPECTED_PROJECT_RUNS", expectedProjectRuns.get().asFile.path)
                exec.environment("PICTURES", pictures.get().asFile.path)
            }
        }
    }
