plugins {
    id("robotran.core")
    id("robotran.physics-web")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:world"))
            api(project(":shared:simulation"))
        }
    }
}
