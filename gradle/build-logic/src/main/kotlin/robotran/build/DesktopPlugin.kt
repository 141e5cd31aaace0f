package robotran.build

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.tasks.JavaExec
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.testing.Test

/** An application for the desktop's JVM with a Compose window; `installDist` puts it together with a start script. */
class DesktopPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        project.pluginManager.apply("application")
        project.pluginManager.apply("org.jetbrains.kotlin.jvm")
        project.pluginManager.apply("org.jetbrains.kotlin.plugin.compose")
        project.pluginManager.apply("org.jetbrains.compose")
        val libraries = catalog(project)
        project.dependencies.add("testImplementation", "org.jetbrains.kotlin:kotlin-test")
        project.dependencies.add("testImplementation", libraries.findLibrary("coroutines-test").get())
        project.tasks.withType(Test::class.java).configureEach { test ->
            test.useJUnitPlatform()
            // The tests run the tree's own examples and test programs and hold them against its recorded runs.
            test.systemProperty("robotran.tree", project.rootDir.path)
            // What opens a window is skipped without one.
            test.inputs.files(FindPrograms.found(project, FindPrograms.DISPLAY)).withPathSensitivity(PathSensitivity.NONE)
            (listOf("examples", "worlds", TEST_PROGRAMS) + RECORDED_RUNS).forEach {
                test.inputs.dir(project.rootProject.file(it)).withPathSensitivity(PathSensitivity.RELATIVE)
            }
        }
        // The folder of the caller, not that of the module, is where the files named on the command line lie.
        project.tasks.named("run", JavaExec::class.java) { it.workingDir = project.rootDir }
        for (type in PACKAGES) addPackage(project, type)
    }

    /** `packageDeb` and the like: the app as a package for a system, in `build/packages`. */
    private fun addPackage(
        project: Project,
        type: String,
    ) {
        project.tasks.register("package${type.replaceFirstChar(Char::uppercase)}", PackageDesktopApp::class.java) { task ->
            task.group = "distribution"
            task.description = "Makes a .$type of the desktop app, with a Java of its own."
            task.dependsOn("installDist")
            task.jars.set(project.layout.buildDirectory.dir("install/robotran/lib"))
            task.resources.set(project.layout.projectDirectory.dir("src/package"))
            task.type.set(type)
            task.version.set(VERSION)
            task.mainClass.set("robotran.desktop.MainKt")
            task.javaHome.set(System.getProperty("java.home"))
            task.output.set(project.layout.buildDirectory.dir("packages/$type"))
        }
    }

    private companion object {
        val PACKAGES = listOf("deb", "msi", "dmg")
        const val VERSION = "0.1.0"
        val RECORDED_RUNS = listOf("shared/simulation/src/commonTest/resources/runs", "shared/programs/src/commonTest/resources/runs")
        const val TEST_PROGRAMS = "shared/robolang/src/commonTest/resources/programs"
    }
}
