plugins {
    id("java-gradle-plugin")
    alias(libs.plugins.kotlin.jvm)
}

dependencies {
    implementation(libs.plugin.kotlin)
}

gradlePlugin {
    plugins {
        create("root") {
            id = "robotran.root"
            implementationClass = "robotran.build.RootPlugin"
        }
        create("core") {
            id = "robotran.core"
            implementationClass = "robotran.build.CorePlugin"
        }
    }
}
