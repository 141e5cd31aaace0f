package robotran.build

import org.gradle.api.GradleException
import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.provider.ListProperty
import org.gradle.api.provider.Property
import org.gradle.api.tasks.Classpath
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.process.ExecOperations
import org.gradle.work.DisableCachingByDefault
import java.io.ByteArrayOutputStream
import javax.inject.Inject

/** Runs benchmarks on the JVM, then in Chromium, never at the same time, and prints and compares the results. */
@DisableCachingByDefault(because = "What is measured is another thing each time")
abstract class BrowserBenchmark
    @Inject
    constructor(private val processes: ExecOperations) :
    BrowserTask(processes) {
        @get:Classpath
        abstract val jvmClasses: ConfigurableFileCollection

        @get:Input
        abstract val jvmMain: Property<String>

        /** The benchmarks to run; empty for all. */
        @get:Input
        abstract val names: ListProperty<String>

        /** The script that opens the page and prints the results. */
        @get:InputFile
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val driver: RegularFileProperty

        @TaskAction
        fun measure() {
            val onJvm = figures(measureOnJvm())
            val inBrowser = figures(measureInBrowser())
            if (onJvm.keys != inBrowser.keys) {
                throw GradleException("The JVM measured ${onJvm.keys}, the browser ${inBrowser.keys}.")
            }
            for ((name, jvm) in onJvm) {
                val browser = inBrowser.getValue(name)
                val ratio = "%.2f".format(browser.substringBefore(' ').toDouble() / jvm.substringBefore(' ').toDouble())
                println("$name: JVM $jvm, Chromium $browser, Chromium / JVM $ratio")
            }
        }

        /** The value after the name in each line. */
        private fun figures(output: String): Map<String, String> =
            output.trim().lines().associate { it.substringBefore(": ") to it.substringAfter(": ") }

        private fun measureOnJvm(): String {
            val output = ByteArrayOutputStream()
            processes.javaexec {
                it.mainClass.set(jvmMain)
                it.classpath(jvmClasses)
                it.args(names.get())
                it.standardOutput = output
            }
            return output.toString()
        }

        private fun measureInBrowser(): String {
            val output = ByteArrayOutputStream()
            runNode(listOf(driver.get().asFile.path) + names.get()) { it.standardOutput = output }
            return output.toString()
        }
    }
