plugins {
    id("robotran.core")
    id("robotran.test-programs")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:rcx-rom"))
        }
    }
}
