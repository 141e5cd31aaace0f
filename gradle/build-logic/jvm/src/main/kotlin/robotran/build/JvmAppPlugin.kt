package robotran.build

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.tasks.JavaExec
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.testing.Test

/** A JVM application. `installDist` adds a start script. */
class JvmAppPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        project.pluginManager.apply("application")
        project.pluginManager.apply("org.jetbrains.kotlin.jvm")
        val libraries = catalog(project)
        project.dependencies.add("testImplementation", "org.jetbrains.kotlin:kotlin-test")
        project.dependencies.add("testImplementation", libraries.findLibrary("coroutines-test").get())
        project.tasks.withType(Test::class.java).configureEach { test ->
            test.useJUnitPlatform()
            // The tests run the examples and test programs of the tree and compare them with its recorded runs.
            test.systemProperty("robotran.tree", project.rootDir.path)
            (listOf("examples", "worlds", TEST_PROGRAMS) + RECORDED_RUNS).forEach {
                test.inputs.dir(project.rootProject.file(it)).withPathSensitivity(PathSensitivity.RELATIVE)
            }
        }
        // File names on the command line are relative to the root folder, not to the module.
        project.tasks.named("run", JavaExec::class.java) { it.workingDir = project.rootDir }
    }

    private companion object {
        val RECORDED_RUNS =
            listOf("shared/simulation/src/commonTest/resources/runs", "shared/programs/src/commonTest/resources/runs")
        const val TEST_PROGRAMS = "shared/robolang/src/commonTest/resources/programs"
    }
}
