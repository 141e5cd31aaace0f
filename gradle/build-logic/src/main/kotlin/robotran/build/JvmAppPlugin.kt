package robotran.build

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.tasks.JavaExec
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.testing.Test

/** An application for the JVM; `installDist` puts it together with a start script. */
class JvmAppPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        project.pluginManager.apply("application")
        project.pluginManager.apply("org.jetbrains.kotlin.jvm")
        val libraries = catalog(project)
        project.dependencies.add("testImplementation", "org.jetbrains.kotlin:kotlin-test")
        project.dependencies.add("testImplementation", libraries.findLibrary("coroutines-test").get())
        project.tasks.withType(Test::class.java).configureEach { test ->
            test.useJUnitPlatform()
            // The tests run the tree's own examples and test programs and hold them against its recorded runs.
            test.systemProperty("robotran.tree", project.rootDir.path)
            (listOf("examples", "worlds", TEST_PROGRAMS) + RECORDED_RUNS).forEach {
                test.inputs.dir(project.rootProject.file(it)).withPathSensitivity(PathSensitivity.RELATIVE)
            }
        }
        // The folder of the caller, not that of the module, is where the files named on the command line lie.
        project.tasks.named("run", JavaExec::class.java) { it.workingDir = project.rootDir }
    }

    private companion object {
        val RECORDED_RUNS =
            listOf("shared/simulation/src/commonTest/resources/runs", "shared/programs/src/commonTest/resources/runs")
        const val TEST_PROGRAMS = "shared/robolang/src/commonTest/resources/programs"
    }
}
