package robotran.build

import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.provider.Property
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.InputFiles
import org.gradle.api.tasks.Optional
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.process.ExecOperations
import java.io.File
import javax.inject.Inject

/** Runs [tests] with Node's test runner. */
@CacheableTask
abstract class BrowserTest
    @Inject
    constructor(processes: ExecOperations) : BrowserTask(processes) {
        @get:InputFiles
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val tests: ConfigurableFileCollection

        /** Modules that the tests import. */
        @get:InputFiles
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val helpers: ConfigurableFileCollection

        /**
         * A file with the paths of browsers other than Chromium, as environment variables for the tests; empty if the
         * tests need no others.
         */
        @get:InputFiles
        @get:PathSensitive(PathSensitivity.NONE)
        abstract val engines: ConfigurableFileCollection

        /** The only engine to visit; absent for all. */
        @get:Input
        @get:Optional
        abstract val onlyEngine: Property<String>

        /**
         * The programs that the page runs. [expectedRuns] and [expectedJavaRuns] hold the expected reports and, for
         * Java, ROM logs; [expectedNxtRuns] and [expectedNxjRuns] the expected reports of an NXT.
         */
        @get:InputFiles
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val examples: ConfigurableFileCollection

        @get:InputDirectory
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val expectedRuns: DirectoryProperty

        @get:InputDirectory
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val expectedJavaRuns: DirectoryProperty

        @get:InputDirectory
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val expectedNxtRuns: DirectoryProperty

        /** Those of Java for an NXT. */
        @get:InputDirectory
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val expectedNxjRuns: DirectoryProperty

        /** Those of NQC, with ROM logs. */
        @get:InputDirectory
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val expectedNqcRuns: DirectoryProperty

        /** Projects that the page runs, each with its expected report. */
        @get:InputDirectory
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val expectedProjectRuns: DirectoryProperty

        /** Classes of hand-ins, and the grades that the page should give them. */
        @get:InputDirectory
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val expectedGrades: DirectoryProperty

        /** Where the screenshots of the tests and of failures go. */
        @get:OutputDirectory
        abstract val pictures: DirectoryProperty

        /**
         * Whether tests take screenshots for people to look at, which takes seconds each, since they are drawn in
         * software. A failure is always photographed.
         */
        @get:Input
        abstract val takesPictures: Property<Boolean>

        /** The results as JUnit XML. */
        @get:OutputDirectory
        abstract val results: DirectoryProperty

        @TaskAction
        fun test() {
            val runner = listOf(
                "--test",
                "--test-concurrency=$CONCURRENT_FILES",
                "--test-reporter=spec",
                "--test-reporter-destination=stdout",
                "--test-reporter=junit",
                "--test-reporter-destination=${results.file("TEST-browser.xml").get().asFile}",
            )
            val lines = engines.files.filter { it.exists() }.flatMap { it.readLines() }
            runNode(runner + tests.files.map { it.path }.sorted()) { exec ->
                for (line in lines) exec.environment(line.substringBefore('='), line.substringAfter('='))
                onlyEngine.orNull?.let { exec.environment("ONLY_ENGINE", it) }
                exec.environment("EXAMPLES", examples.files.joinToString(File.pathSeparator) { it.path })
                exec.environment("EXPECTED_RUNS", expectedRuns.get().asFile.path)
                exec.environment("EXPECTED_JAVA_RUNS", expectedJavaRuns.get().asFile.path)
                exec.environment("EXPECTED_NXT_RUNS", expectedNxtRuns.get().asFile.path)
                exec.environment("EXPECTED_NXJ_RUNS", expectedNxjRuns.get().asFile.path)
                exec.environment("EXPECTED_NQC_RUNS", expectedNqcRuns.get().asFile.path)
                exec.environment("EXPECTED_PROJECT_RUNS", expectedProjectRuns.get().asFile.path)
                exec.environment("EXPECTED_GRADES", expectedGrades.get().asFile.path)
                exec.environment("PICTURES", pictures.get().asFile.path)
                if (takesPictures.get()) exec.environment("TAKES_PICTURES", "yes")
            }
        }

        private companion object {
            /** A test waits for half of its time, so two files of tests keep one processor busy. */
            const val CONCURRENT_FILES = 2
        }
    }
