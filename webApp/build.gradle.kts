plugins {
    id("robotran.web")
}

kotlin {
    sourceSets {
        wasmJsMain.dependencies {
            implementation(project(":shared:ui"))
            implementation(project(":shared:projects"))
            implementation(project(":shared:documents"))
            implementation(libs.coroutines.core)
            implementation(compose.components.resources)
            implementation(npm("qr", "0.7.0"))
        }
    }
}
