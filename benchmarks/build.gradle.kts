plugins {
    id("robotran.benchmarks")
    id("robotran.texts")
}

texts {
    constant("commonMain", "robotran.benchmarks.javaPrograms", "examples/lejos", "*.java")
    constant("commonMain", "robotran.benchmarks.nqcPrograms", "examples/nqc", "*.nqc")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            implementation(project(":shared:programs"))
            implementation(project(":shared:block-editing"))
            implementation(project(":shared:lejos-library"))
            implementation(project(":shared:simulation"))
            implementation(libs.coroutines.core)
            // Compose's compiler plugin, which the UI benchmarks need, requires it on every target.
            implementation(libs.compose.runtime)
        }
        commonMain {
            kotlin.srcDir(rootProject.file("shared/nxt/src/fakeNxtTest/kotlin"))
        }
        jvmMain.dependencies {
            implementation(project(":shared:ui"))
            implementation(project(":shared:ui-world"))
            implementation(project(":shared:projects"))
        }
        jvmMain {
            // Generated texts and their expected properties, shared with the tests.
            kotlin.srcDir(rootProject.file("shared/robolang/src/jvmTest/kotlin/robotran/robolang/fuzz"))
        }
    }
}
