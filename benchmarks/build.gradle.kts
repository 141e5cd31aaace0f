plugins {
    id("application")
    id("org.jetbrains.kotlin.jvm")
}

dependencies {
    implementation(project(":shared:robolang"))
    implementation(project(":shared:world"))
    implementation(project(":shared:physics"))
    implementation(libs.coroutines.core)
}

kotlin {
    sourceSets {
        main {
            // Texts to read and what must be true of them: the same as in the tests.
            kotlin.srcDir("../shared/robolang/src/jvmTest/kotlin/robotran/robolang/fuzz")
        }
    }
}

application {
    mainClass.set("robotran.benchmarks.MainKt")
}
