package robotran.build.teavm

import org.gradle.api.Project
import org.gradle.api.artifacts.Configuration
import org.gradle.api.tasks.compile.JavaCompile

/** The configuration of a Java module that holds the folder of its files for the browser. */
const val WEB_FILES = "webFiles"

/** Makes [project] a Java library. */
internal fun configureJavaModule(project: Project) {
    project.pluginManager.apply("java-library")
    // The compiler may inline a constant into another file, and incremental compilation may miss the dependency.
    project.tasks.withType(JavaCompile::class.java).configureEach { it.options.isIncremental = false }
}

/** A configuration of files that only a build task reads. */
fun toolConfiguration(project: Project, name: String): Configuration = project.configurations.create(name) {
    it.isCanBeConsumed = false
    it.isCanBeResolved = true
}
