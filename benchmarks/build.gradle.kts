plugins {
    id("robotran.benchmarks")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            implementation(project(":shared:robolang"))
            implementation(project(":shared:world"))
            implementation(libs.coroutines.core)
        }
    }
}
