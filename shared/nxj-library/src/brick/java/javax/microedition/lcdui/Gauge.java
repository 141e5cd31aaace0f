package javax.microedition.lcdui;

/** A value from 0 to a highest one in a Form or an Alert, drawn as bars that grow. */
public class Gauge extends Item {
    private int maxValue;
    private int curValue;

    /** Makes one of a label, whether LEFT and RIGHT change it, the highest value and the first one. */
    public Gauge(String label, boolean interactive, int maxValue, int initialValue) {
        this.label = label;
        this.interactive = interactive;
        this.maxValue = maxValue;
        curValue = initialValue;
        minWidth = 2 * maxValue;
        minHeight = maxValue;
        if (label == null) return;
        minWidth += label.length() * Display.CHAR_WIDTH;
        boolean isOneRow = minWidth < Display.SCREEN_WIDTH && maxValue <= Display.CHAR_HEIGHT;
        minHeight = isOneRow ? Display.CHAR_HEIGHT : Display.CHAR_HEIGHT + maxValue;
    }

    /** Gives the highest value. */
    public int getMaxValue() {
        return maxValue;
    }

    /** Sets the highest value. */
    public void setMaxValue(int maxValue) {
        this.maxValue = maxValue;
    }

    /** Gives the value. */
    public int getValue() {
        return curValue;
    }

    /** Sets the value; below 0 it is 0, and above the highest it is the highest. */
    public void setValue(int value) {
        curValue = value < 0 ? 0 : Math.min(value, maxValue);
        repaint();
    }

    /** Is told that a button was pressed, such as Screen.KEY_LEFT. */
    protected void keyPressed(int keyCode) {
        if (keyCode == Screen.KEY_BACK || keyCode == Screen.KEY_ENTER) notifyStateChanged();
        if (keyCode != Screen.KEY_LEFT && keyCode != Screen.KEY_RIGHT) return;
        int next = keyCode == Screen.KEY_RIGHT ? curValue + 1 : curValue - 1;
        if (interactive && next >= 0 && next <= maxValue) curValue = next;
        repaint();
    }

    /** Draws the label, and a bar for each step of the value. */
    public void paint(Graphics g, int x, int y, int w, int h, boolean selected) {
        int across = w / maxValue;
        int up = h / maxValue;
        int left = 0;
        if (label != null) {
            g.drawString(label, x, y, 0, selected);
            if (h > Display.CHAR_HEIGHT) {
                up = (h - Display.CHAR_HEIGHT) / maxValue;
            } else {
                left = label.length() * Display.CHAR_WIDTH;
                across = (w - left) / maxValue;
            }
        }
        for (int i = 0; i < curValue; i++) {
            int barHeight = (i + 1) * up;
            g.fillRect(left + i * across, y + h - barHeight, across >> 1, barHeight);
        }
    }
}
