package lejos.nxt;

/** The memory for files is full, or has no such page. */
public class FlashError extends Error {
    /** Makes one that says what went wrong. */
    public FlashError(String message) {
        super(message);
    }
}
