package robotran.build

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.tasks.testing.Test
import org.jetbrains.kotlin.gradle.ExperimentalWasmDsl
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension
import robotran.build.messages.Messages

/** A module of common Kotlin code for the JVM (desktop, Android) and wasm (browser), tested on both. */
class CorePlugin : Plugin<Project> {
    @OptIn(ExperimentalWasmDsl::class)
    override fun apply(project: Project) {
        project.pluginManager.apply("org.jetbrains.kotlin.multiplatform")
        val libraries = catalog(project)
        val targets = Targets.of(project)
        project.extensions.configure(KotlinMultiplatformExtension::class.java) { kotlin ->
            if (targets.jvm) kotlin.jvm()
            if (targets.wasm) kotlin.wasmJs { nodejs() }
            declareSourceSets(kotlin, "jvmMain", "jvmTest", "wasmJsMain", "wasmJsTest")
            // What may depend on the target: the tests of these folders run as wasm in every check, the others in `checkAll`.
            kotlin.sourceSets.getByName("commonTest").kotlin.srcDir("src/contractTest/kotlin")
            Messages.register(project, "src/commonMain/messages")?.let {
                kotlin.sourceSets.getByName("commonMain").kotlin.srcDir(it)
            }
            kotlin.sourceSets.getByName("commonTest").dependencies {
                implementation(kotlin("test"))
                implementation(libraries.findLibrary("coroutines-test").get())
            }
            kotlin.sourceSets.getByName("jvmTest").dependencies {
                implementation(libraries.findLibrary("kotest-runner").get())
                implementation(libraries.findLibrary("kotest-assertions").get())
                implementation(libraries.findLibrary("kotest-property").get())
            }
        }
        if (targets.wasm) project.pluginManager.apply("robotran.wasm")
        if (targets.jvm) {
            TestParts.registerThorough(project, "jvmTest")
            FuzzTests.register(project)
            Rings.addToQuick(project, "jvmTest")
        }
        project.tasks.withType(Test::class.java).configureEach { test ->
            test.useJUnitPlatform()
            PropertyTests.configure(project, test)
            // The folder of another JDK for the tests, to check that results do not depend on the JDK.
            project.findProperty(TEST_JAVA_PROPERTY)?.let { test.setExecutable("$it/bin/java") }
        }
    }

    private companion object {
        const val TEST_JAVA_PROPERTY = "testJava"
    }
}

/** Creates the source sets of targets that this build leaves out, since build scripts name them. */
fun declareSourceSets(kotlin: KotlinMultiplatformExtension, vararg names: String) =
    names.forEach { kotlin.sourceSets.maybeCreate(it) }
