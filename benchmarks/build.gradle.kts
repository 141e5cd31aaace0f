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
            implementation(project(":shared:world"))
            implementation(libs.coroutines.core)
        }
        jvmMain.dependencies {
            implementation(project(":shared:ui"))
        }
        jvmMain {
            // Texts to read and what must be true of them: the same as in the tests.
            kotlin.srcDir(rootProject.file("shared/robolang/src/jvmTest/kotlin/robotran/robolang/fuzz"))
        }
    }
}
