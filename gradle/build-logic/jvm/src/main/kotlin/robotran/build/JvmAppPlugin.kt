package robotran.build

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.tasks.JavaExec
import org.gradle.api.tasks.testing.Test

/** A JVM application. `installDist` adds a start script. */
class JvmAppPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        project.pluginManager.apply("application")
        project.pluginManager.apply("robotran.jvm-library")
        // The tests run the examples and test programs of the tree and compare them with its recorded runs.
        project.tasks.withType(Test::class.java).configureEach { TestFolders.giveTree(project, it) }
        // File names on the command line are relative to the root folder, not to the module.
        project.tasks.named("run", JavaExec::class.java) { it.workingDir = project.rootDir }
    }
}
