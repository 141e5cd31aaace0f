package robotran.build

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.tasks.JavaExec

/** A plain program for the JVM that measures how fast the others are; no part of `check`, for machines differ. */
class BenchmarksPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        project.pluginManager.apply("application")
        project.pluginManager.apply("org.jetbrains.kotlin.jvm")
        project.tasks.named("run", JavaExec::class.java) { it.workingDir = project.rootDir }
    }
}
