package javax.microedition.lcdui;

import java.util.ArrayList;

/**
 * A screen of items, texts and pictures: LEFT and RIGHT move between items that can be changed, ENTER goes into one.
 *
 * <p>ESCAPE leaves the item, and the listener for items is told; outside of an item it gives the commands.
 */
public class Form extends Screen implements CommandListener {
    private static final Command EDITED = new Command(1, Command.SCREEN, 0);

    private final ArrayList<Object> items = new ArrayList<Object>();
    private ItemStateListener listener;
    private int current;
    private boolean isInside;
    private TextBox keyboard;

    /** Makes an empty one with a title, null for none. */
    public Form(String title) {
        this.title = title;
        keyboard = new TextBox(null, null, 0, TextField.ANY);
        keyboard.setCommandListener(this);
        keyboard.addCommand(EDITED);
    }

    /** Makes one of items; leJOS NXJ gives it no keyboard for a TextField. */
    public Form(String title, Item[] items) {
        this.title = title;
        for (int i = 0; items != null && i < items.length; i++) append(items[i]);
    }

    /** Adds a picture, and gives its place. */
    public int append(Image img) {
        return add(img);
    }

    /** Adds an item, and gives its place. */
    public int append(Item item) {
        return add(item);
    }

    /** Adds a text, and gives its place. */
    public int append(String str) {
        return add(str);
    }

    private int add(Object part) {
        items.add(part);
        return items.size() - 1;
    }

    /** Takes away what is at a place. */
    public void delete(int itemNum) {
        items.remove(itemNum);
    }

    /** Takes away everything. */
    public void deleteAll() {
        items.clear();
    }

    /** Gives what is at a place. */
    public Object get(int itemNum) {
        return items.get(itemNum);
    }

    /** Puts an item in place of what is there. */
    public void set(int itemNum, Item item) {
        items.set(itemNum, item);
    }

    /** Puts an item at a place, before what is there. */
    public void insert(int itemNum, Item item) {
        items.add(itemNum, item);
    }

    /** Gives 0. */
    public int getHeight() {
        return 0;
    }

    /** Gives 0. */
    public int getWidth() {
        return 0;
    }

    /** Gives how many items, texts and pictures there are. */
    public int size() {
        return items.size();
    }

    /** Sets who is told when somebody has changed an item. */
    public void setItemStateListener(ItemStateListener i) {
        listener = i;
    }

    /** Tells the listener for items of the current item. */
    protected void callItemStateListener() {
        Object part = items.get(current);
        if (listener != null && part instanceof Item) listener.itemStateChanged((Item) part);
    }

    /** Is told that a button was pressed, such as KEY_LEFT. */
    protected void keyPressed(int keyCode) {
        if (isInside && current >= 0) keyInside(keyCode);
        else if (keyCode == KEY_RIGHT) right();
        else if (keyCode == KEY_LEFT) left();
        else if (keyCode == KEY_ENTER) enter();
        else if (keyCode == KEY_BACK) {
            for (int i = 0; i < commands.size(); i++) callCommandListener();
        }
        repaint();
    }

    private void keyInside(int keyCode) {
        if (keyCode == KEY_BACK) {
            callItemStateListener();
            isInside = false;
        } else if (keyCode == KEY_RIGHT || keyCode == KEY_LEFT || keyCode == KEY_ENTER) {
            ((Item) items.get(current)).keyPressed(keyCode);
        }
    }

    private void right() {
        int next = current + 1;
        while (next != current) {
            if (next >= items.size()) next = 0;
            if (canBeChanged(next)) {
                current = next;
                return;
            }
            next++;
        }
    }

    private void left() {
        int next = current - 1;
        while (next != current) {
            if (next < 0) next = items.size() - 1;
            if (canBeChanged(next)) {
                current = next;
                return;
            }
            next--;
        }
    }

    private boolean canBeChanged(int place) {
        Object part = items.get(place);
        return part instanceof Item && ((Item) part).isInteractive();
    }

    private void enter() {
        Object part = items.get(current);
        if (!(part instanceof TextField)) {
            isInside = true;
            return;
        }
        TextField field = (TextField) part;
        keyboard.setTitle(field.getLabel());
        keyboard.setText(field.getText());
        keyboard.setMaxSize(field.getMaxSize());
        keyboard.setConstraints(field.getConstraints());
        Display.getDisplay().setCurrent(keyboard);
    }

    /** Is told when somebody has entered a text. */
    public void commandAction(Command c, Displayable d) {
        if (c != EDITED || d != keyboard) return;
        ((TextField) items.get(current)).setText(keyboard.getText());
        callItemStateListener();
        Display.getDisplay().setCurrent(this);
    }

    /** Draws the title and everything else, in rows. */
    public void paint(Graphics g) {
        int x = 0;
        int y = 0;
        ChoiceGroup popup = null;
        int popupX = 0;
        int popupY = 0;
        if (title != null) {
            g.drawString(title, 0, 0, 0);
            y += Display.CHAR_HEIGHT;
        }
        for (int i = 0; i < items.size(); i++) {
            int w = width(i);
            int h = height(i);
            if (x + w < Display.SCREEN_WIDTH && x + w + width(i + 1) > Display.SCREEN_WIDTH) {
                w = Display.SCREEN_WIDTH - x;
            }
            Object part = items.get(i);
            if (part instanceof Image) g.drawImage((Image) part, x, y, 0);
            else if (part instanceof String) g.drawString((String) part, x, y, 0);
            else if (part instanceof Item) ((Item) part).paint(g, x, y, w, h, i == current);
            if (isInside && i == current && part instanceof ChoiceGroup
                    && ((ChoiceGroup) part).choiceType == Choice.POPUP) {
                popup = (ChoiceGroup) part;
                popupX = x;
                popupY = y;
            }
            if (x + w < Display.SCREEN_WIDTH) {
                x += w;
                y += Math.max(0, h - Display.CHAR_HEIGHT);
            } else {
                x = 0;
                y += h;
            }
        }
        if (popup == null) return;
        int rows = popup.size() + (popup.label == null ? 0 : 1);
        int h = Math.min(rows * Display.CHAR_HEIGHT, Display.SCREEN_HEIGHT - popupY);
        popup.paint(g, popupX, popupY, popup.getMinimumWidth(), h, true);
    }

    private int width(int place) {
        Object part = place < items.size() ? items.get(place) : null;
        if (part instanceof Image) return ((Image) part).getWidth();
        if (part instanceof String) return ((String) part).length() * Display.CHAR_WIDTH;
        if (!(part instanceof Item)) return 0;
        return Math.max(((Item) part).getMinimumWidth(), ((Item) part).getPreferredWidth());
    }

    /** How high it is, in whole rows. */
    private int height(int place) {
        Object part = items.get(place);
        int dots = 0;
        if (part instanceof Image) dots = ((Image) part).getHeight();
        if (part instanceof String) dots = Display.CHAR_HEIGHT;
        if (part instanceof Item) dots = Math.max(((Item) part).getMinimumHeight(), ((Item) part).getPreferredHeight());
        return (dots + Display.CHAR_HEIGHT - 1) / Display.CHAR_HEIGHT * Display.CHAR_HEIGHT;
    }
}
