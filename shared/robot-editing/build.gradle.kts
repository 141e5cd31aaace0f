plugins {
    id("robotran.core")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:editing"))
        }
    }
}
