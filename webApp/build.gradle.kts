plugins {
    id("robotran.web")
}

kotlin {
    sourceSets {
        wasmJsMain.dependencies {
            implementation(project(":shared:ui"))
            implementation(project(":shared:projects"))
            implementation(libs.coroutines.core)
        }
    }
}
