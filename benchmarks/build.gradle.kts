plugins {
    id("robotran.benchmarks")
    id("robotran.texts")
}

texts {
    constant("commonMain", "robotran.benchmarks.javaPrograms", "examples/lejos", "*.java")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            implementation(project(":shared:programs"))
            implementation(project(":shared:lejos-library"))
            implementation(project(":shared:simulation"))
            implementation(libs.coroutines.core)
            // The compiler of Compose, which the benchmarks of the screen take, asks for it on every target.
            implementation(libs.compose.runtime)
        }
        jvmMain.dependencies {
            implementation(project(":shared:ui"))
            implementation(project(":shared:projects"))
        }
        jvmMain {
            // Texts to read and what must be true of them: the same as in the tests.
            kotlin.srcDir(rootProject.file("shared/robolang/src/jvmTest/kotlin/robotran/robolang/fuzz"))
        }
    }
}
