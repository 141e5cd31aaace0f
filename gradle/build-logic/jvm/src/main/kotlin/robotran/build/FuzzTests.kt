package robotran.build

import org.gradle.api.Project
import org.gradle.api.tasks.testing.Test
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension

/**
 * The tests of a module that try arbitrary inputs: the classes that [CLASSES] names. In `jvmTest`, and so in `check`, they
 * replay the inputs that once found a fault, and a few of the others with the seed of [PropertyTests]. `fuzzTest`, in
 * `checkAll`, tries all of them, with a new seed in each build.
 */
object FuzzTests {
    const val TASK = "fuzzTest"
    private val CLASSES = listOf("*FuzzTest", "*Properties", "*PropertyTest")

    /** What these tests share, see `Fuzzing.kt` there. */
    private const val KIT = "shared/language/src/fuzzTest/kotlin"

    /** Of property tests that name no number of their own; in `fuzzTest` it is Kotest's 1,000. */
    private const val FEW_INPUTS = 150

    fun register(project: Project) {
        val files = project.fileTree(project.projectDir) { tree ->
            CLASSES.forEach { tree.include("src/jvmTest/**/$it.kt") }
        }
        if (files.isEmpty) return
        val kotlin = project.extensions.getByType(KotlinMultiplatformExtension::class.java)
        kotlin.sourceSets.getByName("jvmTest").kotlin.srcDir(project.rootProject.file(KIT))
        project.tasks.withType(Test::class.java).configureEach { task ->
            task.systemProperty("robotran.fuzz.task", "${project.path}:$TASK")
            if (task.name != TASK) task.systemProperty("kotest.proptest.default.iteration.count", FEW_INPUTS)
        }
        val all = TestParts.register(project, "jvmTest", TASK, CLASSES)
        all.configure { task ->
            task.description = "Tries tens of thousands of arbitrary inputs, on the JVM."
            task.systemProperty("robotran.fuzz.percent", "100")
        }
        Rings.addToAll(project, all)
    }
}
