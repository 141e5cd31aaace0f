plugins {
    id("robotran.core")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:world"))
            implementation(project(":shared:json"))
        }
    }
}
