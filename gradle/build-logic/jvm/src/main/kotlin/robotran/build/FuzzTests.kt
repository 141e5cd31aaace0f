package robotran.build

import org.gradle.api.Project
import org.gradle.api.tasks.testing.Test
import org.gradle.language.base.plugins.LifecycleBasePlugin

/**
 * `fuzzTest`: the tests of a module whose class names end with `FuzzTest`. They try tens of thousands of inputs, so
 * `jvmTest` leaves them out, to be quick after a small change. `check` runs both.
 */
object FuzzTests {
    private const val CLASSES = "*FuzzTest"
    private const val FILES = "src/jvmTest/**/*FuzzTest.kt"

    fun register(project: Project) {
        if (project.fileTree(project.projectDir) { it.include(FILES) }.isEmpty) return
        val jvmTest = project.tasks.named("jvmTest", Test::class.java)
        jvmTest.configure { it.filter.excludeTestsMatching(CLASSES) }
        val fuzzTest = project.tasks.register("fuzzTest", Test::class.java) { task ->
            task.group = LifecycleBasePlugin.VERIFICATION_GROUP
            task.description = "Runs the tests with tens of thousands of inputs, on the JVM."
            task.testClassesDirs = project.files(jvmTest.map { it.testClassesDirs })
            task.classpath = project.files(jvmTest.map { it.classpath })
            task.filter.includeTestsMatching(CLASSES)
        }
        project.tasks.named(LifecycleBasePlugin.CHECK_TASK_NAME) { it.dependsOn(fuzzTest) }
    }
}
