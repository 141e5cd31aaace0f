package robotran.build

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.tasks.JavaExec
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
            TestFolders.giveTree(project, test)
        }
        // File names on the command line are relative to the root folder, not to the module.
        project.tasks.named("run", JavaExec::class.java) { it.workingDir = project.rootDir }
    }
}
