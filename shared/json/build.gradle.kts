plugins {
    id("robotran.core")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(libs.serialization.json)
        }
    }
}
