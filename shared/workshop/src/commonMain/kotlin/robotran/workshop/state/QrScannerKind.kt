package robotran.workshop.state

/** Where a scanner looks for QR codes. */
enum class QrScannerKind {
    /** Before the camera, which shows them live. */
    CAMERA,

    /** In a picture that the user takes now, with the camera app of the device. */
    PHOTO,

    /** In pictures that the user chooses. */
    PICTURES,
}
