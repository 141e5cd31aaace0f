package javax.microedition.lcdui;

/** Which of many items are in the rows of a display, and which of them the buttons have reached. */
class ScrolledRows {
    int current;
    int first;
    int last;
    boolean wraps = true;

    void right(int count) {
        if (wraps) current = (current + 1) % count;
        else if (current < count - 1) current++;
    }

    void left(int count) {
        if (current > 0) current--;
        else if (wraps) current = count - 1;
    }

    /** Moves so that the current item is in one of so many rows. */
    void show(int count, int rows) {
        if (current == 0) {
            first = 0;
            last = rows;
        } else if (count >= rows && current >= count - 1) {
            first = count - rows;
            last = count - 1;
        } else if (current >= last) {
            first++;
            last++;
        } else if (current < first) {
            first--;
            last--;
        }
    }
}
