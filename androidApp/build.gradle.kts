plugins {
    id("robotran.android.app")
}

android {
    namespace = "robotran.android"
    defaultConfig {
        applicationId = "org.robotran.app"
        versionCode = 1
        versionName = "0.1"
    }
}

dependencies {
    implementation(project(":shared:ui"))
    implementation(project(":shared:ui-school"))
    implementation(project(":shared:projects"))
    implementation(project(":shared:documents"))
    implementation(libs.androidx.activity.compose)
    testImplementation(project(":shared:qr-code"))
    testImplementation(libs.androidx.compose.ui.test)
    testImplementation(libs.junit4)
    testImplementation(libs.robolectric)
}
