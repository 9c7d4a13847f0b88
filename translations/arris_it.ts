<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="it_IT">
<context>
    <name>Corner</name>
    <message>
        <source>sharp</source>
        <translation>acuto</translation>
    </message>
    <message>
        <source>blunt</source>
        <translation>ottuso</translation>
    </message>
    <message>
        <source>concave</source>
        <translation>concavo</translation>
    </message>
    <message>
        <source>transition</source>
        <translation>transizione</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>aggiramento</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>arco</translation>
    </message>
    <message>
        <source>exact stop</source>
        <translation>arresto preciso</translation>
    </message>
    <message>
        <source>Sharp: on a transition path the wheel lifts clear of the tip.</source>
        <translation>Acuto: nella transizione la mola si stacca dalla punta.</translation>
    </message>
    <message>
        <source>Sharp, but the wheel cannot lift clear of the tip: it takes the transition path all the same.</source>
        <translation>Acuto, ma la mola non può staccarsi del tutto dalla punta: la transizione viene eseguita ugualmente.</translation>
    </message>
    <message>
        <source>Blunt, so not fragile: the wheel rolls round the corner.</source>
        <translation>Ottuso, quindi non fragile: la mola aggira lo spigolo.</translation>
    </message>
    <message>
        <source>from the angle</source>
        <translation>dall&apos;angolo</translation>
    </message>
    <message>
        <source>limited by the X axis</source>
        <translation>limitata dall&apos;asse X</translation>
    </message>
    <message>
        <source>limited by the Y axis</source>
        <translation>limitata dall&apos;asse Y</translation>
    </message>
    <message>
        <source>scaled by the corner speed</source>
        <translation>scalata con la vel. di spigolo</translation>
    </message>
    <message>
        <source>Other glass is in the way of a transition path: the wheel rolls round the corner.</source>
        <translation>Altro vetro impedisce la transizione: la mola aggira lo spigolo.</translation>
    </message>
    <message>
        <source>Concave, but shallow: an arc takes the place of the path&apos;s kink.</source>
        <translation>Concavo ma molto aperto: un arco sostituisce la piega del percorso.</translation>
    </message>
    <message>
        <source>Concave: the wheel stops where it touches both edges.</source>
        <translation>Concavo: la mola si arresta dove tocca entrambi i lati.</translation>
    </message>
</context>
<context>
    <name>Fault</name>
    <message>
        <source>The emergency stop has tripped.</source>
        <translation>È scattato l&apos;arresto di emergenza.</translation>
    </message>
    <message>
        <source>Somebody pressed it, or its circuit is open.</source>
        <translation>È stato premuto, oppure il suo circuito è aperto.</translation>
    </message>
    <message>
        <source>Make the machine safe, release the button, acknowledge.</source>
        <translation>Mettere in sicurezza la macchina, sbloccare il pulsante, confermare.</translation>
    </message>
    <message>
        <source>The encoder of {axis} gives no signal.</source>
        <translation>{axis}: l&apos;encoder non dà segnale.</translation>
    </message>
    <message>
        <source>A cable is broken or loose, or the encoder is dirty.</source>
        <translation>Un cavo è rotto o allentato, oppure l&apos;encoder è sporco.</translation>
    </message>
    <message>
        <source>The axes report nothing any more.</source>
        <translation>Gli assi non comunicano più.</translation>
    </message>
    <message>
        <source>The connection to the drives is broken.</source>
        <translation>Il collegamento con gli azionamenti è interrotto.</translation>
    </message>
    <message>
        <source>A set-point of {axis} was no number, or jumped by {value} mm/s² more than the axis can follow.</source>
        <translation>{axis}: un setpoint non era un numero, o è saltato di {value} mm/s² oltre il limite dell&apos;asse.</translation>
    </message>
    <message>
        <source>A fault in Arris.</source>
        <translation>Un errore in Arris.</translation>
    </message>
    <message>
        <source>Save a support bundle and report it. Acknowledge to go on.</source>
        <translation>Salvare un pacchetto di assistenza e segnalarlo. Confermare per continuare.</translation>
    </message>
    <message>
        <source>{axis} stands {value} mm away from its set-point.</source>
        <translation>{axis}: l&apos;asse è a {value} mm dal suo setpoint.</translation>
    </message>
    <message>
        <source>The axis is blocked, or its drive is too weak.</source>
        <translation>L&apos;asse è bloccato, oppure l&apos;azionamento è troppo debole.</translation>
    </message>
    <message>
        <source>Free the axis, check the drive, acknowledge.</source>
        <translation>Liberare l&apos;asse, verificare l&apos;azionamento, confermare.</translation>
    </message>
    <message>
        <source>The drive of {axis} reports a fault.</source>
        <translation>{axis}: l&apos;azionamento segnala un guasto.</translation>
    </message>
    <message>
        <source>Overload, overheating, or a fault in the supply.</source>
        <translation>Sovraccarico, surriscaldamento o guasto dell&apos;alimentazione.</translation>
    </message>
    <message>
        <source>The drive of {axis} is not ready.</source>
        <translation>{axis}: l&apos;azionamento non è pronto.</translation>
    </message>
    <message>
        <source>Its supply is off, or a safety circuit is open.</source>
        <translation>L&apos;alimentazione è spenta, oppure un circuito di sicurezza è aperto.</translation>
    </message>
    <message>
        <source>{axis} has hit a limit switch.</source>
        <translation>{axis}: è stato raggiunto un finecorsa.</translation>
    </message>
    <message>
        <source>The axis ran past the end of its travel.</source>
        <translation>L&apos;asse ha superato la fine della sua corsa.</translation>
    </message>
    <message>
        <source>Acknowledge, jog the axis back, home again.</source>
        <translation>Confermare, riportare indietro l&apos;asse in jog, ripetere l&apos;azzeramento.</translation>
    </message>
    <message>
        <source>{axis} would leave its travel.</source>
        <translation>{axis}: l&apos;asse uscirebbe dalla sua corsa.</translation>
    </message>
    <message>
        <source>The origin was moved, or the pattern lies too far out.</source>
        <translation>L&apos;origine è stata spostata, oppure la sagoma è troppo all&apos;esterno.</translation>
    </message>
    <message>
        <source>Acknowledge, set the origin, load the job again.</source>
        <translation>Confermare, impostare l&apos;origine, ricaricare il lavoro.</translation>
    </message>
    <message>
        <source>{axis} has not found its reference switch.</source>
        <translation>{axis}: il finecorsa di zero non è stato trovato.</translation>
    </message>
    <message>
        <source>The switch is broken, or the axis did not move.</source>
        <translation>Il finecorsa è guasto, oppure l&apos;asse non si è mosso.</translation>
    </message>
    <message>
        <source>Check the switch and the axis, acknowledge, home again.</source>
        <translation>Verificare finecorsa e asse, confermare, ripetere l&apos;azzeramento.</translation>
    </message>
    <message>
        <source>The rotary buffers ran dry; the wheel was stopped on its path.</source>
        <translation>I buffer circolari si sono svuotati; la mola è stata fermata sul suo percorso.</translation>
    </message>
    <message>
        <source>The computer was too busy to supply the controller.</source>
        <translation>Il computer era troppo occupato per alimentare il controllo.</translation>
    </message>
    <message>
        <source>Close other programs, acknowledge, resume the job.</source>
        <translation>Chiudere gli altri programmi, confermare, riprendere il lavoro.</translation>
    </message>
    <message>
        <source>The axes report late, by {value} ms.</source>
        <translation>Gli assi rispondono con {value} ms di ritardo.</translation>
    </message>
    <message>
        <source>The computer or the connection to the drives is overloaded.</source>
        <translation>Il computer o il collegamento con gli azionamenti è sovraccarico.</translation>
    </message>
    <message>
        <source>The axes had no set-point for {value} periods.</source>
        <translation>Gli assi sono rimasti senza setpoint per {value} cicli.</translation>
    </message>
    <message>
        <source>The computer was too busy to supply them in time.</source>
        <translation>Il computer era troppo occupato per fornirli in tempo.</translation>
    </message>
    <message>
        <source>The operator&apos;s side has not answered for half a second.</source>
        <translation>L&apos;interfaccia operatore non risponde da mezzo secondo.</translation>
    </message>
    <message>
        <source>The program hangs or has ended.</source>
        <translation>Il programma è bloccato o terminato.</translation>
    </message>
    <message>
        <source>Start Arris again, resume the job.</source>
        <translation>Riavviare Arris, riprendere il lavoro.</translation>
    </message>
    <message>
        <source>The spindle has lost its speed on the glass.</source>
        <translation>Il mandrino ha perso velocità sul vetro.</translation>
    </message>
    <message>
        <source>The wheel is overloaded or blocked, or the spindle&apos;s drive has a fault.</source>
        <translation>La mola è sovraccarica o bloccata, oppure l&apos;azionamento del mandrino è guasto.</translation>
    </message>
    <message>
        <source>Check wheel and spindle, acknowledge, resume the job.</source>
        <translation>Verificare mola e mandrino, confermare, riprendere il lavoro.</translation>
    </message>
    <message>
        <source>The coolant has stopped flowing on the glass.</source>
        <translation>Il refrigerante è mancato sul vetro.</translation>
    </message>
    <message>
        <source>The tank is empty, or the pump or a filter is blocked.</source>
        <translation>La vasca è vuota, oppure la pompa o un filtro è intasato.</translation>
    </message>
    <message>
        <source>The vacuum does not hold the glass.</source>
        <translation>Il vuoto non tiene il vetro.</translation>
    </message>
    <message>
        <source>A cup leaks, or the pump is off.</source>
        <translation>Una ventosa perde, oppure la pompa è spenta.</translation>
    </message>
    <message>
        <source>Check cups and pump, place the glass again, acknowledge.</source>
        <translation>Verificare ventose e pompa, riposizionare il vetro, confermare.</translation>
    </message>
    <message>
        <source>The spindle does not reach its speed.</source>
        <translation>Il mandrino non raggiunge la sua velocità.</translation>
    </message>
    <message>
        <source>The spindle&apos;s drive is off or has a fault.</source>
        <translation>L&apos;azionamento del mandrino è spento o guasto.</translation>
    </message>
    <message>
        <source>Check the spindle, acknowledge, start again.</source>
        <translation>Verificare il mandrino, confermare, riavviare.</translation>
    </message>
    <message>
        <source>The coolant does not flow.</source>
        <translation>Il refrigerante non scorre.</translation>
    </message>
    <message>
        <source>The tank is empty, a valve is closed, or the pump is off.</source>
        <translation>La vasca è vuota, una valvola è chiusa o la pompa è spenta.</translation>
    </message>
    <message>
        <source>Check the coolant, acknowledge, start again.</source>
        <translation>Verificare il refrigerante, confermare, riavviare.</translation>
    </message>
    <message>
        <source>an axis</source>
        <translation>Un asse</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 mm/s²</source>
        <translation>%1 mm/s²</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 periods</source>
        <translation>%1 cicli</translation>
    </message>
    <message>
        <source>Repair the encoder or its cable, acknowledge, home again.</source>
        <translation>Riparare l&apos;encoder o il suo cavo, confermare, ripetere l&apos;azzeramento.</translation>
    </message>
    <message>
        <source>Restore the connection, acknowledge, home again.</source>
        <translation>Ripristinare il collegamento, confermare, ripetere l&apos;azzeramento.</translation>
    </message>
    <message>
        <source>Read the drive&apos;s display, clear its fault, acknowledge.</source>
        <translation>Leggere il display dell&apos;azionamento, eliminare il guasto, confermare.</translation>
    </message>
    <message>
        <source>Switch its supply on, close the safety circuit, acknowledge.</source>
        <translation>Accendere l&apos;alimentazione, chiudere il circuito di sicurezza, confermare.</translation>
    </message>
    <message>
        <source>Restore the coolant, acknowledge, resume the job.</source>
        <translation>Ripristinare il refrigerante, confermare, riprendere il lavoro.</translation>
    </message>
</context>
<context>
    <name>JobSheet</name>
    <message>
        <source>yes</source>
        <translation>sì</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>X %1, Y %2 mm</source>
        <translation>X %1, Y %2 mm</translation>
    </message>
    <message>
        <source>chosen by the program</source>
        <translation>scelto dal programma</translation>
    </message>
    <message>
        <source>Job sheet: %1</source>
        <translation>Scheda di lavoro: %1</translation>
    </message>
    <message>
        <source>X reversed</source>
        <translation>X invertita</translation>
    </message>
    <message>
        <source>Y reversed</source>
        <translation>Y invertita</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>cm</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>pollice</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>piede</translation>
    </message>
    <message>
        <source>Accelerations bind</source>
        <translation>Limiti di accelerazione</translation>
    </message>
    <message>
        <source>each axis on its own</source>
        <translation>per ogni asse</translation>
    </message>
    <message>
        <source>X and Y together</source>
        <translation>X e Y insieme</translation>
    </message>
    <message>
        <source>Direction round outlines</source>
        <translation>Senso sui contorni esterni</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>orario</translation>
    </message>
    <message>
        <source>counter-clockwise</source>
        <translation>antiorario</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>Specchiatura</translation>
    </message>
    <message>
        <source>Unit of the drawing</source>
        <translation>Unità del disegno</translation>
    </message>
    <message>
        <source>as its file says</source>
        <translation>come da file</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Layer</translation>
    </message>
    <message>
        <source>all</source>
        <translation>tutti</translation>
    </message>
    <message>
        <source>What the wheel cannot reach may stay unground</source>
        <translation>Non molare dove la mola non arriva</translation>
    </message>
    <message>
        <source>Start nearest to</source>
        <translation>Inizio più vicino a</translation>
    </message>
    <message>
        <source>Lower left of the pane</source>
        <translation>In basso a sinistra della lastra</translation>
    </message>
    <message>
        <source>Travel</source>
        <translation>Corsa</translation>
    </message>
    <message>
        <source>Greatest speed</source>
        <translation>Velocità massima</translation>
    </message>
    <message>
        <source>Greatest acceleration</source>
        <translation>Accelerazione massima</translation>
    </message>
    <message>
        <source>Park position</source>
        <translation>Posizione di parcheggio</translation>
    </message>
    <message>
        <source>Feed when going down</source>
        <translation>Avanzamento in discesa</translation>
    </message>
    <message>
        <source>Period of the axes</source>
        <translation>Periodo degli assi</translation>
    </message>
    <message>
        <source>Back-off from the glass</source>
        <translation>Allontanamento dal vetro</translation>
    </message>
    <message>
        <source>%1 mm after %2 s</source>
        <translation>%1 mm dopo %2 s</translation>
    </message>
    <message>
        <source>Following error allowed</source>
        <translation>Errore inseguimento ammesso</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Spigolo</translation>
    </message>
    <message>
        <source>Contour</source>
        <translation>Contorno</translation>
    </message>
    <message>
        <source>Angle β</source>
        <translation>Angolo β</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Treatment</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Speed v, mm/s</source>
        <translation>Vel. v, mm/s</translation>
    </message>
    <message>
        <source>Time t, s</source>
        <translation>Tempo t, s</translation>
    </message>
    <message>
        <source>Relief margin, mm</source>
        <translation>Marg. distacco, mm</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Spigoli</translation>
    </message>
    <message>
        <source>None.</source>
        <translation>Nessuno.</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Tempi</translation>
    </message>
    <message>
        <source>The pattern cannot be ground.</source>
        <translation>La sagoma non è molabile.</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Fase</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durata</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Quota</translation>
    </message>
    <message>
        <source>Grinding, lead-in to lead-out</source>
        <translation>Molatura, da attacco a uscita</translation>
    </message>
    <message>
        <source>Whole program</source>
        <translation>Intero programma</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Pagina %1 di %2</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Ricetta</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Macchina</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problemi</translation>
    </message>
    <message>
        <source>Repairs of the drawing</source>
        <translation>Riparazioni del disegno</translation>
    </message>
    <message>
        <source>%1, continued</source>
        <translation>%1, continua</translation>
    </message>
</context>
<context>
    <name>JobState</name>
    <message>
        <source>Idle</source>
        <translation>Inattivo</translation>
    </message>
    <message>
        <source>Queued</source>
        <translation>In coda</translation>
    </message>
    <message>
        <source>Released</source>
        <translation>Autorizzato</translation>
    </message>
    <message>
        <source>Initialized</source>
        <translation>Caricato</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>In corso</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Sospeso</translation>
    </message>
    <message>
        <source>Aborted</source>
        <translation>Interrotto</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Terminato</translation>
    </message>
</context>
<context>
    <name>Legend</name>
    <message>
        <source>Finished contour</source>
        <translation>Contorno finito</translation>
    </message>
    <message>
        <source>Not in a contour</source>
        <translation>Fuori dai contorni</translation>
    </message>
    <message>
        <source>Wheel path</source>
        <translation>Percorso mola</translation>
    </message>
    <message>
        <source>Corner transition</source>
        <translation>Transizione spigolo</translation>
    </message>
    <message>
        <source>Lead-in, lead-out</source>
        <translation>Attacco, uscita</translation>
    </message>
    <message>
        <source>Rapid above the glass</source>
        <translation>Rapido sopra il vetro</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inizio</translation>
    </message>
    <message>
        <source>Wheel down, up</source>
        <translation>Mola giù, su</translation>
    </message>
    <message>
        <source>Travel of the machine</source>
        <translation>Corsa della macchina</translation>
    </message>
    <message>
        <source>Slower between these</source>
        <translation>Più lento fra questi</translation>
    </message>
    <message>
        <source>Roll or arc at a corner</source>
        <translation>Aggiramento o arco</translation>
    </message>
    <message>
        <source>Stop in a concave corner</source>
        <translation>Arresto: spigolo concavo</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Errore</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avviso</translation>
    </message>
    <message>
        <source>Note, repair</source>
        <translation>Nota, riparazione</translation>
    </message>
</context>
<context>
    <name>Machine</name>
    <message>
        <source>Feed of plunges</source>
        <translation>Avanzamento in discesa</translation>
    </message>
    <message>
        <source>Servo period</source>
        <translation>Periodo servo</translation>
    </message>
    <message>
        <source>Homing: speed towards the switch</source>
        <translation>Azzeramento: vel. verso il finecorsa</translation>
    </message>
    <message>
        <source>Homing: speed off the switch</source>
        <translation>Azzeramento: vel. dal finecorsa</translation>
    </message>
    <message>
        <source>Fastest jog</source>
        <translation>Velocità massima in jog</translation>
    </message>
    <message>
        <source>Set-points ahead of time</source>
        <translation>Anticipo dei setpoint</translation>
    </message>
    <message>
        <source>Greatest following error</source>
        <translation>Errore di inseguimento massimo</translation>
    </message>
    <message>
        <source>Backing off in a hold</source>
        <translation>Allontanamento in pausa</translation>
    </message>
    <message>
        <source>At rest before backing off</source>
        <translation>Sosta prima di allontanarsi</translation>
    </message>
    <message>
        <source>Longest wait for spindle and coolant</source>
        <translation>Attesa massima di mandrino e refrigerante</translation>
    </message>
    <message>
        <source>Travel of the axes</source>
        <translation>Corsa degli assi</translation>
    </message>
    <message>
        <source>Greatest speeds of the axes</source>
        <translation>Velocità massime degli assi</translation>
    </message>
    <message>
        <source>Greatest accelerations of the axes</source>
        <translation>Accelerazioni massime degli assi</translation>
    </message>
    <message>
        <source>Park position</source>
        <translation>Posizione di parcheggio</translation>
    </message>
    <message>
        <source>Reference switches</source>
        <translation>Finecorsa di zero</translation>
    </message>
    <message>
        <source>Jog only while the panel&apos;s jog enable is held</source>
        <translation>Jog solo tenendo premuto il consenso jog sul pannello</translation>
    </message>
</context>
<context>
    <name>Phase</name>
    <message>
        <source>Approach</source>
        <translation>Avvicinamento</translation>
    </message>
    <message>
        <source>Plunge</source>
        <translation>Discesa</translation>
    </message>
    <message>
        <source>Lead-in</source>
        <translation>Attacco</translation>
    </message>
    <message>
        <source>Cruise</source>
        <translation>Vel. costante</translation>
    </message>
    <message>
        <source>Decelerate</source>
        <translation>Decelerazione</translation>
    </message>
    <message>
        <source>Transition</source>
        <translation>Transizione</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Aggiramento</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arresto</translation>
    </message>
    <message>
        <source>Accelerate</source>
        <translation>Accelerazione</translation>
    </message>
    <message>
        <source>Lead-out</source>
        <translation>Uscita</translation>
    </message>
    <message>
        <source>Retract</source>
        <translation>Risalita</translation>
    </message>
    <message>
        <source>Traverse</source>
        <translation>Trasferimento</translation>
    </message>
</context>
<context>
    <name>PreviewPage</name>
    <message>
        <source>on the table</source>
        <translation>sulla tavola</translation>
    </message>
    <message>
        <source>of the drawing</source>
        <translation>del disegno</translation>
    </message>
    <message>
        <source>X %1, mm</source>
        <translation>X %1, mm</translation>
    </message>
    <message>
        <source>Y %1, mm</source>
        <translation>Y %1, mm</translation>
    </message>
    <message>
        <source>Scale 1 : %1</source>
        <translation>Scala 1 : %1</translation>
    </message>
    <message>
        <source>No contour</source>
        <translation>Nessun contorno</translation>
    </message>
    <message>
        <source>Pane %1, lower left at X %2, Y %3</source>
        <translation>Lastra %1, in basso a sinistra X %2, Y %3</translation>
    </message>
    <message>
        <source>glass %1 mm</source>
        <translation>vetro %1 mm</translation>
    </message>
    <message>
        <source>corners: %1</source>
        <translation>spigoli: %1</translation>
    </message>
    <message>
        <source>Wheel R %1 mm · depth %2 mm · feed %3 mm/min · acceleration X %4, Y %5 mm/s²</source>
        <translation>Mola R %1 mm · profondità %2 mm · avanzamento %3 mm/min · accelerazione X %4, Y %5 mm/s²</translation>
    </message>
    <message>
        <source>Cannot be ground</source>
        <translation>Non molabile</translation>
    </message>
    <message>
        <source>Grinding %1 · whole program %2 · wheel path %3 mm</source>
        <translation>Molatura %1 · intero programma %2 · percorso mola %3 mm</translation>
    </message>
    <message>
        <source>pieces in no contour: %1</source>
        <translation>elementi fuori dai contorni: %1</translation>
    </message>
    <message>
        <source>… and %1 more kinds of findings</source>
        <translation>… altri tipi di segnalazioni: %1</translation>
    </message>
    <message>
        <source>Contours: %1 (outlines %2, cut-outs %3)</source>
        <translation>Contorni: %1 (esterni %2, interni %3)</translation>
    </message>
    <message>
        <source>And %1 more like it.</source>
        <translation>Altri simili: %1.</translation>
    </message>
    <message>
        <source>Contours: %1</source>
        <translation>Contorni: %1</translation>
    </message>
</context>
<context>
    <name>Problem</name>
    <message>
        <source>{file} cannot be opened: {reason}.</source>
        <translation>Impossibile aprire {file}: {reason}.</translation>
    </message>
    <message>
        <source>{file} cannot be read: {reason}.</source>
        <translation>Impossibile leggere {file}: {reason}.</translation>
    </message>
    <message>
        <source>{file} cannot be written: {reason}.</source>
        <translation>Impossibile scrivere {file}: {reason}.</translation>
    </message>
    <message>
        <source>{file} is not valid JSON: {reason}.</source>
        <translation>{file} non è un JSON valido: {reason}.</translation>
    </message>
    <message>
        <source>{file} has no &quot;{key}&quot;: it is not such a file.</source>
        <translation>{file} non contiene «{key}»: non è un file di questo tipo.</translation>
    </message>
    <message>
        <source>{file} was written by a newer Arris (&quot;{key}&quot;: {version}); this one reads up to {known}.</source>
        <translation>{file} è stato scritto da un Arris più recente («{key}»: {version}); questo legge fino a {known}.</translation>
    </message>
    <message>
        <source>{file} has a key &quot;{key}&quot; that Arris does not know; it is ignored.</source>
        <translation>{file} contiene una chiave «{key}» che Arris non conosce; viene ignorata.</translation>
    </message>
    <message>
        <source>{name} must be {expected}, not {value}.</source>
        <translation>{name} deve essere {expected}, non {value}.</translation>
    </message>
    <message>
        <source>{name} must be a number in {unit}, not &quot;{value}&quot;.</source>
        <translation>{name} deve essere un numero in {unit}, non «{value}».</translation>
    </message>
    <message>
        <source>{name} is {value} {unit}; it must be from {least} to {most} {unit}.</source>
        <translation>{name} è {value} {unit}; deve essere da {least} a {most} {unit}.</translation>
    </message>
    <message>
        <source>{name} is {value} {unit}; the machine allows {most} {unit} at most.</source>
        <translation>{name} è {value} {unit}; la macchina ammette al massimo {most} {unit}.</translation>
    </message>
    <message>
        <source>{name} is &quot;{value}&quot;; it must be one of: {choices}.</source>
        <translation>{name} è «{value}»; valori ammessi: {choices}.</translation>
    </message>
    <message>
        <source>{file} is not a profile of Arris: {reason}.</source>
        <translation>{file} non è un profilo di Arris: {reason}.</translation>
    </message>
    <message>
        <source>The pattern file is empty.</source>
        <translation>Il file della sagoma è vuoto.</translation>
    </message>
    <message>
        <source>This is not a DXF file: {reason}.</source>
        <translation>Questo non è un file DXF: {reason}.</translation>
    </message>
    <message>
        <source>The lines end in carriage returns alone; save the file with LF or CR LF.</source>
        <translation>Le righe terminano solo con ritorno a capo (CR); salvare il file con LF o CR LF.</translation>
    </message>
    <message>
        <source>A group code is expected here, not {found}.</source>
        <translation>Qui è atteso un codice di gruppo, non {found}.</translation>
    </message>
    <message>
        <source>Group {group} must hold a finite number, not {found}.</source>
        <translation>Il gruppo {group} deve contenere un numero finito, non {found}.</translation>
    </message>
    <message>
        <source>Group {group} holds {found}, which is absurd for a pane of glass (more than {most}).</source>
        <translation>Il gruppo {group} contiene {found}: assurdo per una lastra di vetro (più di {most}).</translation>
    </message>
    <message>
        <source>The file ends early: {reason}. It was cut off.</source>
        <translation>Il file finisce troppo presto: {reason}. È stato troncato.</translation>
    </message>
    <message>
        <source>The sections of the file are broken: {reason}.</source>
        <translation>Le sezioni del file sono danneggiate: {reason}.</translation>
    </message>
    <message>
        <source>{entity} announces {announced} {what} but has {found}.</source>
        <translation>{entity} dichiara {announced} {what} ma ne ha {found}.</translation>
    </message>
    <message>
        <source>{entity} lacks group {group} ({what}).</source>
        <translation>{entity}: manca il gruppo {group} ({what}).</translation>
    </message>
    <message>
        <source>{entity} has {what} {value}, which cannot be.</source>
        <translation>{entity} ha {what} {value}: non è possibile.</translation>
    </message>
    <message>
        <source>The file does not say its unit; millimetres are assumed.</source>
        <translation>Il file non indica l&apos;unità di misura; si assumono millimetri.</translation>
    </message>
    <message>
        <source>The file gives its unit as number {number}, which is not mm, cm, m, inch or foot; say the unit with --units.</source>
        <translation>Il file indica come unità il numero {number}, che non è mm, cm, m, pollice o piede; indicare l&apos;unità con --units.</translation>
    </message>
    <message>
        <source>{count} × {entity} not read yet; the contour would lack it.</source>
        <translation>{count} × {entity}: lettura non ancora possibile; mancherebbe nel contorno.</translation>
    </message>
    <message>
        <source>{count} × {entity} not flat in a plane parallel to the XY plane.</source>
        <translation>{count} × {entity}: non giace su un piano parallelo al piano XY.</translation>
    </message>
    <message>
        <source>{count} × {entity} passed over: {reason}.</source>
        <translation>{count} × {entity}, ignorato: {reason}.</translation>
    </message>
    <message>
        <source>{count} more of {code} are not listed.</source>
        <translation>Altri {code} non elencati: {count}.</translation>
    </message>
    <message>
        <source>A doubled piece of {size_mm} mm was removed.</source>
        <translation>È stato rimosso un elemento doppio di {size_mm} mm.</translation>
    </message>
    <message>
        <source>A piece without length ({size_mm} mm) was removed.</source>
        <translation>È stato rimosso un elemento senza lunghezza ({size_mm} mm).</translation>
    </message>
    <message>
        <source>A gap of {size_mm} mm was closed.</source>
        <translation>È stata chiusa un&apos;interruzione di {size_mm} mm.</translation>
    </message>
    <message>
        <source>The contour is open here: the next free end is {gap_mm} mm away (up to {tolerance_mm} mm are joined).</source>
        <translation>Il contorno è aperto qui: l&apos;estremo libero più vicino dista {gap_mm} mm (si unisce fino a {tolerance_mm} mm).</translation>
    </message>
    <message>
        <source>{count} pieces meet here; a contour cannot branch.</source>
        <translation>Qui si incontrano {count} elementi; un contorno non può ramificarsi.</translation>
    </message>
    <message>
        <source>The drawing has no closed contour.</source>
        <translation>Il disegno non ha contorni chiusi.</translation>
    </message>
    <message>
        <source>The contour encloses no area.</source>
        <translation>Il contorno non racchiude alcuna area.</translation>
    </message>
    <message>
        <source>The contour crosses or touches itself here.</source>
        <translation>Qui il contorno incrocia o tocca sé stesso.</translation>
    </message>
    <message>
        <source>The contour turns back on itself here, in a tip of {angle_deg}°; that is a mistake of the drawing.</source>
        <translation>Qui il contorno torna su sé stesso, con una punta di {angle_deg}°; è un errore del disegno.</translation>
    </message>
    <message>
        <source>Corner {corner}: the wheel lifts by {lift_mm} mm, less than the {depth_mm} mm of glass at the tip.</source>
        <translation>Spigolo {corner}: la mola si stacca di {lift_mm} mm, meno dei {depth_mm} mm di vetro alla punta.</translation>
    </message>
    <message>
        <source>Corner {corner} takes {time_s} s.</source>
        <translation>Lo spigolo {corner} richiede {time_s} s.</translation>
    </message>
    <message>
        <source>The overlap is {used_mm} mm, a quarter of the contour, instead of {wanted_mm} mm.</source>
        <translation>La sovrapposizione è di {used_mm} mm, un quarto del contorno, invece di {wanted_mm} mm.</translation>
    </message>
    <message>
        <source>The wheel path leaves the travel of the machine by {excess_mm} mm: {what}.</source>
        <translation>Il percorso mola esce dalla corsa della macchina di {excess_mm} mm: {what}.</translation>
    </message>
    <message>
        <source>The wheel&apos;s lower face would be {height_mm} mm above the table while grinding; it must stay {least_mm} mm above.</source>
        <translation>In molatura la faccia inferiore della mola sarebbe a {height_mm} mm dalla tavola; deve restare ad almeno {least_mm} mm.</translation>
    </message>
    <message>
        <source>The {what} height of {height_mm} mm is outside the travel of 0 to {most_mm} mm.</source>
        <translation>La quota di {what} di {height_mm} mm è fuori dalla corsa da 0 a {most_mm} mm.</translation>
    </message>
    <message>
        <source>The grinding height of {height_mm} mm is above the clearance height of {clearance_mm} mm.</source>
        <translation>La quota di molatura di {height_mm} mm è sopra la quota di sicurezza di {clearance_mm} mm.</translation>
    </message>
    <message>
        <source>The machine&apos;s greatest speed of the {axis} axis is below the feed; it limits the speed on the contour.</source>
        <translation>La velocità massima dell&apos;asse {axis} è inferiore all&apos;avanzamento; limita la velocità sul contorno.</translation>
    </message>
    <message>
        <source>Internal error: {reason}.</source>
        <translation>Errore interno: {reason}.</translation>
    </message>
    <message>
        <source>Axes through LinuxCNC are not available: {reason}.</source>
        <translation>Assi tramite LinuxCNC non disponibili: {reason}.</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Errore</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avviso</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Nota</translation>
    </message>
    <message>
        <source>A single piece, its ends {length_mm} mm apart, belongs to no contour; it may lie on top of another.</source>
        <translation>Un elemento isolato, con estremi a {length_mm} mm l&apos;uno dall&apos;altro, non appartiene ad alcun contorno; forse è sovrapposto a un altro.</translation>
    </message>
    <message>
        <source>The wheel cannot {what} here: it needs {needed_mm} mm between its centre and the glass and has {distance_mm} mm. Start on a longer edge away from sharp corners, or change the lead&apos;s radius.</source>
        <translation>Qui la mola non può {what}: tra il suo centro e il vetro servono {needed_mm} mm e ce ne sono {distance_mm} mm. Iniziare su un lato più lungo, lontano da spigoli acuti, o cambiare il raggio di attacco e uscita.</translation>
    </message>
    <message>
        <source>At the park position the wheel&apos;s lower face would be {height_mm} mm above the table, over or beside the glass; it must be {least_mm} mm above.</source>
        <translation>In posizione di parcheggio la faccia inferiore della mola sarebbe a {height_mm} mm dalla tavola, sopra o accanto al vetro; deve essere ad almeno {least_mm} mm.</translation>
    </message>
    <message>
        <source>The binary DXF file is damaged: {reason}.</source>
        <translation>Il file DXF binario è danneggiato: {reason}.</translation>
    </message>
    <message>
        <source>Block {block} is defined twice, first on line {first}; give one of them another name.</source>
        <translation>Il blocco {block} è definito due volte, la prima alla riga {first}; rinominare uno dei due.</translation>
    </message>
    <message>
        <source>{count} × INSERT of block {entity}, which the file does not have; explode it before saving.</source>
        <translation>{count} × INSERT del blocco {entity}, che il file non contiene; esploderlo prima di salvare.</translation>
    </message>
    <message>
        <source>Block {block} inserts itself here, or blocks are nested more than {most} deep; explode it before saving.</source>
        <translation>Qui il blocco {block} inserisce sé stesso, o i blocchi sono annidati oltre {most} livelli; esploderlo prima di salvare.</translation>
    </message>
    <message>
        <source>INSERT of block {entity} would make more than {most} pieces of the drawing; draw fewer copies.</source>
        <translation>INSERT del blocco {entity} produrrebbe più di {most} elementi del disegno; disegnare meno copie.</translation>
    </message>
    <message>
        <source>The SPLINE is no curve: {reason}.</source>
        <translation>La SPLINE non è una curva: {reason}.</translation>
    </message>
    <message>
        <source>From here on the curves of the drawing are too long or too many to follow with arcs ({most} steps).</source>
        <translation>Da qui in poi le curve del disegno sono troppo lunghe o troppe per seguirle con archi ({most} passi).</translation>
    </message>
    <message>
        <source>{entity} lies {distance_mm} mm away, which is absurd for a pane of glass (more than {most_mm} mm).</source>
        <translation>{entity} si trova a {distance_mm} mm di distanza: assurdo per una lastra di vetro (più di {most_mm} mm).</translation>
    </message>
    <message>
        <source>A piece ends here on another one, between that one&apos;s ends; a contour cannot branch. Remove one of them.</source>
        <translation>Qui un elemento termina su un altro, fra gli estremi di questo; un contorno non può ramificarsi. Rimuoverne uno.</translation>
    </message>
    <message>
        <source>Contours {first} and {second} cross or touch here; move them apart in the drawing.</source>
        <translation>Qui i contorni {first} e {second} si incrociano o si toccano; distanziarli nel disegno.</translation>
    </message>
    <message>
        <source>The {count} joints from here on look like the chords of a curve but stay corners: they are joined from a smoothing tolerance of {needed_mm} mm on (now {tolerance_mm} mm).</source>
        <translation>Le {count} giunzioni da qui in poi sembrano corde di una curva ma restano spigoli: si uniscono con una tolleranza di approssimazione da {needed_mm} mm in su (ora {tolerance_mm} mm).</translation>
    </message>
    <message>
        <source>The wheel of {wheel_mm} mm radius does not reach {length_mm} mm of the contour here; up to {left_mm} mm of glass would stay. Take a wheel of at most {largest_mm} mm, or accept that this stays unground.</source>
        <translation>La mola di raggio {wheel_mm} mm non raggiunge qui {length_mm} mm di contorno; resterebbero fino a {left_mm} mm di vetro. Usare una mola di {largest_mm} mm al massimo, o accettare che resti non molato.</translation>
    </message>
    <message>
        <source>The wheel of {wheel_mm} mm radius does not reach {length_mm} mm of the contour here; up to {left_mm} mm of glass stay. A wheel of at most {largest_mm} mm would.</source>
        <translation>La mola di raggio {wheel_mm} mm non raggiunge qui {length_mm} mm di contorno; restano fino a {left_mm} mm di vetro. Ci arriverebbe una mola di {largest_mm} mm al massimo.</translation>
    </message>
    <message>
        <source>The wheel of {wheel_mm} mm radius does not reach this contour of {length_mm} mm at all. Take a wheel of less than {largest_mm} mm, or accept that it stays unground.</source>
        <translation>La mola di raggio {wheel_mm} mm non raggiunge affatto questo contorno di {length_mm} mm. Usare una mola di meno di {largest_mm} mm, o accettare che resti non molato.</translation>
    </message>
    <message>
        <source>This contour of {length_mm} mm stays unground: the wheel of {wheel_mm} mm radius does not reach it. A wheel of less than {largest_mm} mm would.</source>
        <translation>Questo contorno di {length_mm} mm resta non molato: la mola di raggio {wheel_mm} mm non lo raggiunge. Ci arriverebbe una mola di meno di {largest_mm} mm.</translation>
    </message>
    <message>
        <source>The wheel of {wheel_mm} mm radius reaches no contour at all.</source>
        <translation>La mola di raggio {wheel_mm} mm non raggiunge alcun contorno.</translation>
    </message>
    <message>
        <source>Corner {corner} is concave: the wheel leaves {fillet_mm} mm of glass before it, and {unground_mm} mm of its edges are not ground.</source>
        <translation>Lo spigolo {corner} è concavo: la mola lascia {fillet_mm} mm di vetro davanti ad esso, e {unground_mm} mm dei suoi lati non vengono molati.</translation>
    </message>
    <message>
        <source>Corner {corner}: a transition would touch other glass here; the wheel rolls round the corner instead.</source>
        <translation>Spigolo {corner}: qui una transizione toccherebbe altro vetro; la mola aggira invece lo spigolo.</translation>
    </message>
    <message>
        <source>A size correction of {correction_mm} mm would change the shape of the contour here.</source>
        <translation>Una correzione di misura di {correction_mm} mm cambierebbe qui la forma del contorno.</translation>
    </message>
    <message>
        <source>The wheel cannot {what} here: it needs {needed_mm} mm between its centre and the glass and has {distance_mm} mm. What it would grind from here stays unground.</source>
        <translation>Qui la mola non può {what}: tra il suo centro e il vetro servono {needed_mm} mm e ce ne sono {distance_mm} mm. Ciò che molerebbe da qui resta non molato.</translation>
    </message>
    <message>
        <source>(line %1 of the file, at X %2, Y %3 mm)</source>
        <translation>(riga %1 del file, a X %2, Y %3 mm)</translation>
    </message>
    <message>
        <source>(line %1 of the file)</source>
        <translation>(riga %1 del file)</translation>
    </message>
    <message>
        <source>(at X %1, Y %2 mm)</source>
        <translation>(a X %1, Y %2 mm)</translation>
    </message>
    <message>
        <source>From here on so many contours lie over or within each other that they cannot be checked (more than {most} comparisons); draw fewer.</source>
        <translation>Da qui in poi troppi contorni sono sovrapposti o annidati per poterli controllare (più di {most} confronti); disegnarne meno.</translation>
    </message>
    <message>
        <source>{file} is not the record of a run: {reason}.</source>
        <translation>{file} non è la registrazione di un&apos;esecuzione: {reason}.</translation>
    </message>
    <message>
        <source>{file} is not whole: {reason} at byte {byte}. What can be read is used.</source>
        <translation>{file} non è completo: {reason} al byte {byte}. Si usa ciò che è leggibile.</translation>
    </message>
    <message>
        <source>{file} is damaged and was kept as {kept}; hours and metres are counted from zero.</source>
        <translation>{file} è danneggiato ed è stato conservato come {kept}; ore e metri vengono contati da zero.</translation>
    </message>
    <message>
        <source>{file} is not a back-up that can be restored: {reason}.</source>
        <translation>{file} non è un backup ripristinabile: {reason}.</translation>
    </message>
    <message>
        <source>The job that was broken off is of another pattern or an earlier state of it: {file} had the fingerprint {was}, now it has {is}.</source>
        <translation>Il lavoro interrotto riguarda un&apos;altra sagoma o una sua versione precedente: {file} aveva l&apos;impronta {was}, ora ha {is}.</translation>
    </message>
    <message>
        <source>The job that was broken off was planned for another machine: {key} was {was}, now it is {is}.</source>
        <translation>Il lavoro interrotto era stato calcolato per un&apos;altra macchina: {key} era {was}, ora è {is}.</translation>
    </message>
    <message>
        <source>The place where the job was broken off (segment {segment}, {lambda_mm} mm) is not on the job as it is planned now.</source>
        <translation>Il punto in cui il lavoro è stato interrotto (segmento {segment}, {lambda_mm} mm) non si trova sul lavoro come è calcolato ora.</translation>
    </message>
    <message>
        <source>{file} is damaged and has no effect; it was kept as {aside}.</source>
        <translation>{file} è danneggiato e non ha effetto; è stato conservato come {aside}.</translation>
    </message>
    <message>
        <source>It was given up before it was done.</source>
        <translation>L&apos;operazione è stata annullata prima della fine.</translation>
    </message>
</context>
<context>
    <name>ProblemWord</name>
    <message>
        <source>No such file or directory</source>
        <translation>file o cartella inesistente</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>accesso negato</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>è una cartella</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>errore di ingresso/uscita</translation>
    </message>
    <message>
        <source>it holds NUL bytes</source>
        <translation>contiene byte NUL</translation>
    </message>
    <message>
        <source>it is a DWG drawing; save it as DXF</source>
        <translation>è un disegno DWG; salvarlo come DXF</translation>
    </message>
    <message>
        <source>it is UTF-16 text; save it as ASCII DXF</source>
        <translation>è un testo UTF-16; salvarlo come DXF ASCII</translation>
    </message>
    <message>
        <source>it begins with {} and not with a group code</source>
        <translation>inizia con {} e non con un codice di gruppo</translation>
    </message>
    <message>
        <source>an empty line</source>
        <translation>una riga vuota</translation>
    </message>
    <message>
        <source>the last group code has no value</source>
        <translation>l&apos;ultimo codice di gruppo non ha valore</translation>
    </message>
    <message>
        <source>there is no EOF</source>
        <translation>manca EOF</translation>
    </message>
    <message>
        <source>there is no EOF; the last POLYLINE has no SEQEND</source>
        <translation>manca EOF; l&apos;ultima POLYLINE non ha SEQEND</translation>
    </message>
    <message>
        <source>there is no EOF, and section {} has no ENDSEC</source>
        <translation>manca EOF, e la sezione {} non ha ENDSEC</translation>
    </message>
    <message>
        <source>section {} has no ENDSEC before the next SECTION</source>
        <translation>la sezione {} non ha ENDSEC prima della SECTION successiva</translation>
    </message>
    <message>
        <source>section {} has no ENDSEC before EOF</source>
        <translation>la sezione {} non ha ENDSEC prima di EOF</translation>
    </message>
    <message>
        <source>ENDSEC without a SECTION</source>
        <translation>ENDSEC senza SECTION</translation>
    </message>
    <message>
        <source>the section has no name</source>
        <translation>la sezione non ha nome</translation>
    </message>
    <message>
        <source>the POLYLINE of line {} has no SEQEND</source>
        <translation>la POLYLINE della riga {} non ha SEQEND</translation>
    </message>
    <message>
        <source>the POLYLINE of line {} has no SEQEND before {}</source>
        <translation>la POLYLINE della riga {} non ha SEQEND prima di {}</translation>
    </message>
    <message>
        <source>{} without a POLYLINE before it</source>
        <translation>{} senza una POLYLINE che lo preceda</translation>
    </message>
    <message>
        <source>group {} belongs to no entity</source>
        <translation>il gruppo {} non appartiene ad alcuna entità</translation>
    </message>
    <message>
        <source>group {} stands outside of any section</source>
        <translation>il gruppo {} è fuori da ogni sezione</translation>
    </message>
    <message>
        <source>{} stands outside of any section</source>
        <translation>{} è fuori da ogni sezione</translation>
    </message>
    <message>
        <source>group {}</source>
        <translation>il gruppo {}</translation>
    </message>
    <message>
        <source>twice</source>
        <translation>due volte</translation>
    </message>
    <message>
        <source>X of its start</source>
        <translation>X dell&apos;inizio</translation>
    </message>
    <message>
        <source>Y of its start</source>
        <translation>Y dell&apos;inizio</translation>
    </message>
    <message>
        <source>X of its end</source>
        <translation>X della fine</translation>
    </message>
    <message>
        <source>Y of its end</source>
        <translation>Y della fine</translation>
    </message>
    <message>
        <source>X of its centre</source>
        <translation>X del centro</translation>
    </message>
    <message>
        <source>Y of its centre</source>
        <translation>Y del centro</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>raggio</translation>
    </message>
    <message>
        <source>start angle</source>
        <translation>angolo iniziale</translation>
    </message>
    <message>
        <source>end angle</source>
        <translation>angolo finale</translation>
    </message>
    <message>
        <source>the radius</source>
        <translation>il raggio</translation>
    </message>
    <message>
        <source>a bulge of</source>
        <translation>una curvatura (bulge) di</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>vertici</translation>
    </message>
    <message>
        <source>on layer {}, which is never plotted</source>
        <translation>sul layer {}, che non viene mai stampato</translation>
    </message>
    <message>
        <source>layer {} is frozen</source>
        <translation>il layer {} è congelato</translation>
    </message>
    <message>
        <source>layer {} is off</source>
        <translation>il layer {} è disattivato</translation>
    </message>
    <message>
        <source>in paper space</source>
        <translation>nello spazio carta</translation>
    </message>
    <message>
        <source>no part of a contour</source>
        <translation>non fa parte di un contorno</translation>
    </message>
    <message>
        <source>invisible</source>
        <translation>invisibile</translation>
    </message>
    <message>
        <source>go down</source>
        <translation>scendere</translation>
    </message>
    <message>
        <source>come up</source>
        <translation>risalire</translation>
    </message>
    <message>
        <source>lead in</source>
        <translation>eseguire l&apos;attacco</translation>
    </message>
    <message>
        <source>lead out</source>
        <translation>eseguire l&apos;uscita</translation>
    </message>
    <message>
        <source>the lead-in</source>
        <translation>attacco</translation>
    </message>
    <message>
        <source>the lead-out</source>
        <translation>uscita</translation>
    </message>
    <message>
        <source>the transition at corner {}</source>
        <translation>transizione allo spigolo {}</translation>
    </message>
    <message>
        <source>the roll round corner {}</source>
        <translation>aggiramento dello spigolo {}</translation>
    </message>
    <message>
        <source>the way along the contour</source>
        <translation>tratto lungo il contorno</translation>
    </message>
    <message>
        <source>clearance</source>
        <translation>sicurezza</translation>
    </message>
    <message>
        <source>grinding</source>
        <translation>molatura</translation>
    </message>
    <message>
        <source>this Arris was built without them; install linuxcnc-uspace-dev and build it again</source>
        <translation>questo Arris è stato compilato senza; installare linuxcnc-uspace-dev e ricompilarlo</translation>
    </message>
    <message>
        <source>install linuxcnc-uspace; {}</source>
        <translation>installare linuxcnc-uspace; {}</translation>
    </message>
    <message>
        <source>the module is of another version of Arris</source>
        <translation>il modulo è di un&apos;altra versione di Arris</translation>
    </message>
    <message>
        <source>another Arris drives them already</source>
        <translation>sono già comandati da un altro Arris</translation>
    </message>
    <message>
        <source>this user may not reach the HAL session</source>
        <translation>questo utente non ha accesso alla sessione HAL</translation>
    </message>
    <message>
        <source>HAL has no memory left</source>
        <translation>HAL ha esaurito la memoria</translation>
    </message>
    <message>
        <source>no HAL session for Arris runs; start one with packaging/hal/start.sh</source>
        <translation>non è attiva alcuna sessione HAL per Arris; avviarla con packaging/hal/start.sh</translation>
    </message>
    <message>
        <source>the HAL session has no signal {} that fits; compare its file with packaging/hal</source>
        <translation>la sessione HAL non ha un segnale {} adatto; confrontare il suo file con packaging/hal</translation>
    </message>
    <message>
        <source>the HAL session lacks streamer cfg=ffff or sampler cfg=fffff; compare its file with packaging/hal</source>
        <translation>nella sessione HAL manca streamer cfg=ffff o sampler cfg=fffff; confrontare il suo file con packaging/hal</translation>
    </message>
    <message>
        <source>an Arris that died has left the HAL session unfinished; start it again with packaging/hal/start.sh</source>
        <translation>un Arris interrotto ha lasciato incompiuta la sessione HAL; riavviarla con packaging/hal/start.sh</translation>
    </message>
    <message>
        <source>the threads of the HAL session do not run</source>
        <translation>i thread della sessione HAL non sono in esecuzione</translation>
    </message>
    <message>
        <source>the HAL session&apos;s streamer is not emptied, or somebody else fills it</source>
        <translation>lo streamer della sessione HAL non viene svuotato, o qualcun altro lo riempie</translation>
    </message>
    <message>
        <source>the HAL session&apos;s period is {} s, the machine&apos;s {} s</source>
        <translation>il periodo della sessione HAL è {} s, quello della macchina {} s</translation>
    </message>
    <message>
        <source>knots</source>
        <translation>nodi</translation>
    </message>
    <message>
        <source>control points</source>
        <translation>punti di controllo</translation>
    </message>
    <message>
        <source>fit points</source>
        <translation>punti di interpolazione</translation>
    </message>
    <message>
        <source>X of its major axis</source>
        <translation>X dell&apos;asse maggiore</translation>
    </message>
    <message>
        <source>Y of its major axis</source>
        <translation>Y dell&apos;asse maggiore</translation>
    </message>
    <message>
        <source>ratio of its axes</source>
        <translation>rapporto tra gli assi</translation>
    </message>
    <message>
        <source>a ratio of axes of</source>
        <translation>un rapporto tra gli assi di</translation>
    </message>
    <message>
        <source>name of the block</source>
        <translation>nome del blocco</translation>
    </message>
    <message>
        <source>a major axis of</source>
        <translation>un asse maggiore di</translation>
    </message>
    <message>
        <source>layer {} is not chosen</source>
        <translation>il layer {} non è selezionato</translation>
    </message>
    <message>
        <source>block {} has no ENDBLK</source>
        <translation>il blocco {} non ha ENDBLK</translation>
    </message>
    <message>
        <source>{} stands outside of any block</source>
        <translation>{} è fuori da ogni blocco</translation>
    </message>
    <message>
        <source>ENDBLK without a BLOCK</source>
        <translation>ENDBLK senza BLOCK</translation>
    </message>
    <message>
        <source>its first line is broken</source>
        <translation>la prima riga è danneggiata</translation>
    </message>
    <message>
        <source>byte {} begins no group</source>
        <translation>al byte {} non inizia alcun gruppo</translation>
    </message>
    <message>
        <source>it ends within the group at byte {}</source>
        <translation>finisce all&apos;interno del gruppo al byte {}</translation>
    </message>
    <message>
        <source>its degree is {}; up to {} are read</source>
        <translation>il grado è {}; si legge fino a {}</translation>
    </message>
    <message>
        <source>it has {} control points and needs {}</source>
        <translation>ha {} punti di controllo e ne richiede {}</translation>
    </message>
    <message>
        <source>it has {} knots and needs {}</source>
        <translation>ha {} nodi e ne richiede {}</translation>
    </message>
    <message>
        <source>its knots fall from {} to {}</source>
        <translation>i nodi scendono da {} a {}</translation>
    </message>
    <message>
        <source>its knots are all the same</source>
        <translation>i nodi sono tutti uguali</translation>
    </message>
    <message>
        <source>it has {} weights and needs {}</source>
        <translation>ha {} pesi e ne richiede {}</translation>
    </message>
    <message>
        <source>it has a weight of {}, which is not positive</source>
        <translation>ha un peso di {}, che non è positivo</translation>
    </message>
    <message>
        <source>its weights reach from {} to {}</source>
        <translation>i pesi vanno da {} a {}</translation>
    </message>
    <message>
        <source>it breaks apart</source>
        <translation>si spezza</translation>
    </message>
    <message>
        <source>it does not begin like one</source>
        <translation>non inizia come tale</translation>
    </message>
    <message>
        <source>its header is damaged</source>
        <translation>l&apos;intestazione è danneggiata</translation>
    </message>
    <message>
        <source>it breaks off</source>
        <translation>si interrompe</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>è danneggiato</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>file troppo grande</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>il file è vuoto</translation>
    </message>
    <message>
        <source>it has no rows</source>
        <translation>non ha righe</translation>
    </message>
    <message>
        <source>the time does not increase</source>
        <translation>il tempo non aumenta</translation>
    </message>
    <message>
        <source>the column {} is missing</source>
        <translation>manca la colonna {}</translation>
    </message>
    <message>
        <source>the column {} stands twice</source>
        <translation>la colonna {} compare due volte</translation>
    </message>
    <message>
        <source>{} fields instead of {}</source>
        <translation>{} campi invece di {}</translation>
    </message>
    <message>
        <source>distance_mm must be empty where corner is 0</source>
        <translation>distance_mm deve essere vuoto dove corner è 0</translation>
    </message>
    <message>
        <source>{} must be a finite number, not {}</source>
        <translation>{} deve essere un numero finito, non {}</translation>
    </message>
    <message>
        <source>{} must be a whole number from 0 on, not {}</source>
        <translation>{} deve essere un numero intero da 0 in su, non {}</translation>
    </message>
    <message>
        <source>{} is no phase</source>
        <translation>{} non è una fase</translation>
    </message>
    <message>
        <source>it is no archive of Arris</source>
        <translation>non è un archivio di Arris</translation>
    </message>
    <message>
        <source>it is damaged or cut off</source>
        <translation>è danneggiato o troncato</translation>
    </message>
    <message>
        <source>it is larger than a back-up can be</source>
        <translation>è più grande di quanto possa essere un backup</translation>
    </message>
    <message>
        <source>it does not say what it is</source>
        <translation>non dice che cosa sia</translation>
    </message>
    <message>
        <source>it is a support bundle</source>
        <translation>è un pacchetto di assistenza</translation>
    </message>
    <message>
        <source>{} is no plain file</source>
        <translation>{} non è un file normale</translation>
    </message>
    <message>
        <source>{} stands there twice</source>
        <translation>{} compare due volte</translation>
    </message>
    <message>
        <source>{} is no part of a back-up</source>
        <translation>{} non fa parte di un backup</translation>
    </message>
    <message>
        <source>{} is not valid</source>
        <translation>{} non è valido</translation>
    </message>
</context>
<context>
    <name>ProfilePage</name>
    <message>
        <source>Corner with its angle: from A to C</source>
        <translation>Spigolo con il suo angolo: da A a C</translation>
    </message>
    <message>
        <source>Braking before, accelerating after</source>
        <translation>Frenata prima, accelerazione dopo</translation>
    </message>
    <message>
        <source>Limit, feed, wheel radius R</source>
        <translation>Limite, avanzamento, raggio mola R</translation>
    </message>
    <message>
        <source>R + depth at the tip</source>
        <translation>R + profondità alla punta</translation>
    </message>
    <message>
        <source>Work %1 of %2 · wheel R %3 mm · feed %4 mm/min · acceleration X %5, Y %6 mm/s²</source>
        <translation>Molatura %1 su %2 · mola R %3 mm · avanzamento %4 mm/min · accelerazione X %5, Y %6 mm/s²</translation>
    </message>
    <message>
        <source>Between contours</source>
        <translation>Fra i contorni</translation>
    </message>
    <message>
        <source>End of the travel</source>
        <translation>Fine della corsa</translation>
    </message>
    <message>
        <source>Way of the wheel&apos;s centre</source>
        <translation>Percorso del centro mola</translation>
    </message>
    <message>
        <source>In a corner, from A to C</source>
        <translation>In uno spigolo, da A a C</translation>
    </message>
    <message>
        <source>Glass</source>
        <translation>Vetro</translation>
    </message>
</context>
<context>
    <name>Quantities</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 h %2 min</translation>
    </message>
</context>
<context>
    <name>Recipe</name>
    <message>
        <source>Wheel radius</source>
        <translation>Raggio mola</translation>
    </message>
    <message>
        <source>Thickness of the wheel</source>
        <translation>Spessore mola</translation>
    </message>
    <message>
        <source>Fine adjustment of the grinding height</source>
        <translation>Regolazione fine della quota di molatura</translation>
    </message>
    <message>
        <source>Normal grinding depth</source>
        <translation>Profondità di molatura</translation>
    </message>
    <message>
        <source>Thickness of the glass</source>
        <translation>Spessore vetro</translation>
    </message>
    <message>
        <source>Underside of the glass above the table</source>
        <translation>Faccia inferiore del vetro sopra la tavola</translation>
    </message>
    <message>
        <source>Wheel&apos;s lower face above the glass when traversing</source>
        <translation>Faccia inferiore della mola sopra il vetro nel trasferimento</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Avanzamento</translation>
    </message>
    <message>
        <source>Acceleration of the X axis</source>
        <translation>Accelerazione asse X</translation>
    </message>
    <message>
        <source>Acceleration of the Y axis</source>
        <translation>Accelerazione asse Y</translation>
    </message>
    <message>
        <source>Acceleration of the Z axis</source>
        <translation>Accelerazione asse Z</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>Velocità mandrino</translation>
    </message>
    <message>
        <source>Transition speed at sharp corners</source>
        <translation>Velocità di transizione agli spigoli acuti</translation>
    </message>
    <message>
        <source>Size correction (positive leaves the pane larger)</source>
        <translation>Correzione di misura (positiva: lastra più grande)</translation>
    </message>
    <message>
        <source>Radius of the lead-in and lead-out</source>
        <translation>Raggio di attacco e uscita</translation>
    </message>
    <message>
        <source>Overlap past the start</source>
        <translation>Sovrapposizione oltre l&apos;inizio</translation>
    </message>
    <message>
        <source>Rotation of the pattern</source>
        <translation>Rotazione della sagoma</translation>
    </message>
    <message>
        <source>Gaps up to this are closed</source>
        <translation>Chiudi interruzioni fino a</translation>
    </message>
    <message>
        <source>Tolerance of fitting chopped curves</source>
        <translation>Tolleranza di approssimazione curve</translation>
    </message>
    <message>
        <source>Accelerations bind</source>
        <translation>Limiti di accelerazione</translation>
    </message>
    <message>
        <source>each axis</source>
        <translation>per ogni asse</translation>
    </message>
    <message>
        <source>X and Y together</source>
        <translation>X e Y insieme</translation>
    </message>
    <message>
        <source>Direction round the pane</source>
        <translation>Senso attorno alla lastra</translation>
    </message>
    <message>
        <source>clockwise</source>
        <translation>orario</translation>
    </message>
    <message>
        <source>counter-clockwise</source>
        <translation>antiorario</translation>
    </message>
    <message>
        <source>Mirror the pattern</source>
        <translation>Specchiatura sagoma</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>left to right (X)</source>
        <translation>sinistra-destra (X)</translation>
    </message>
    <message>
        <source>top to bottom (Y)</source>
        <translation>alto-basso (Y)</translation>
    </message>
    <message>
        <source>Unit of the drawing</source>
        <translation>Unità del disegno</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>pollice</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>piede</translation>
    </message>
</context>
<context>
    <name>Services</name>
    <message>
        <source>Spindle: %1
Coolant: %2
Vacuum: %3</source>
        <translation>Mandrino: %1
Refrigerante: %2
Vuoto: %3</translation>
    </message>
    <message>
        <source>off</source>
        <translation>spento</translation>
    </message>
    <message>
        <source>at speed</source>
        <translation>a regime</translation>
    </message>
    <message>
        <source>comes up to speed</source>
        <translation>in accelerazione</translation>
    </message>
    <message>
        <source>flows</source>
        <translation>scorre</translation>
    </message>
    <message>
        <source>holds the glass</source>
        <translation>tiene il vetro</translation>
    </message>
</context>
<context>
    <name>SimulatedFault</name>
    <message>
        <source>Coolant fails</source>
        <translation>Manca il refrigerante</translation>
    </message>
    <message>
        <source>Spindle fails</source>
        <translation>Guasto mandrino</translation>
    </message>
    <message>
        <source>Vacuum fails</source>
        <translation>Manca il vuoto</translation>
    </message>
    <message>
        <source>Drive of X fails</source>
        <translation>Guasto azionam. X</translation>
    </message>
    <message>
        <source>X is stuck</source>
        <translation>X è bloccato</translation>
    </message>
    <message>
        <source>Emergency stop trips</source>
        <translation>Scatta l&apos;emergenza</translation>
    </message>
</context>
<context>
    <name>Stage</name>
    <message>
        <source>Reading the drawing…</source>
        <translation>Lettura disegno…</translation>
    </message>
    <message>
        <source>Joining and fitting…</source>
        <translation>Unione e approssimazione…</translation>
    </message>
    <message>
        <source>Laying the wheel path…</source>
        <translation>Calcolo percorso mola…</translation>
    </message>
    <message>
        <source>Planning the speeds…</source>
        <translation>Calcolo velocità…</translation>
    </message>
    <message>
        <source>Computing the profile…</source>
        <translation>Calcolo profilo…</translation>
    </message>
    <message>
        <source>%1 (%2 of %3)</source>
        <extracomment>What is under way, its number, and how many there are.</extracomment>
        <translation>%1 (%2 di %3)</translation>
    </message>
</context>
<context>
    <name>State</name>
    <message>
        <source>Drives off</source>
        <translation>Azionamenti spenti</translation>
    </message>
    <message>
        <source>Not homed</source>
        <translation>Non azzerata</translation>
    </message>
    <message>
        <source>Homing</source>
        <translation>Azzeramento</translation>
    </message>
    <message>
        <source>Ready</source>
        <translation>Pronta</translation>
    </message>
    <message>
        <source>Starting</source>
        <translation>In avvio</translation>
    </message>
    <message>
        <source>Running</source>
        <translation>In lavorazione</translation>
    </message>
    <message>
        <source>Holding</source>
        <translation>Va in pausa</translation>
    </message>
    <message>
        <source>Held</source>
        <translation>In pausa</translation>
    </message>
    <message>
        <source>Stepping</source>
        <translation>Passo-passo</translation>
    </message>
    <message>
        <source>Jogging</source>
        <translation>Jog</translation>
    </message>
    <message>
        <source>Positioning</source>
        <translation>Posizionamento</translation>
    </message>
    <message>
        <source>Stopping</source>
        <translation>In arresto</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Guasto</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>Emergenza</translation>
    </message>
</context>
<context>
    <name>Wheel</name>
    <message>
        <source>%1, corner %2</source>
        <translation>%1, spigolo %2</translation>
    </message>
    <message>
        <source>%1 s of %2</source>
        <translation>%1 s di %2</translation>
    </message>
    <message>
        <source>%1 mm/s</source>
        <translation>%1 mm/s</translation>
    </message>
    <message>
        <source>%1 mm to the corner</source>
        <translation>%1 mm dallo spigolo</translation>
    </message>
    <message>
        <source>Planned: X %1  Y %2  Z %3 mm</source>
        <translation>Previsto: X %1  Y %2  Z %3 mm</translation>
    </message>
</context>
<context>
    <name>arris::ui::AlarmBanner</name>
    <message>
        <source>Acknowledge</source>
        <translation>Conferma</translation>
    </message>
    <message>
        <source>No job is loaded</source>
        <translation>Nessun lavoro caricato</translation>
    </message>
    <message>
        <source>%1 of %2 panes good</source>
        <translation>Lastre buone: %1 di %2</translation>
    </message>
    <message>
        <source>Simulated axes</source>
        <translation>Assi simulati</translation>
    </message>
    <message>
        <source>LinuxCNC: no axes</source>
        <translation>LinuxCNC: nessun asse</translation>
    </message>
    <message>
        <source>Axes through LinuxCNC</source>
        <translation>Assi tramite LinuxCNC</translation>
    </message>
    <message>
        <source> (+%1 on the page Alarms)</source>
        <translation> (+%1 nella pagina «Allarmi»)</translation>
    </message>
</context>
<context>
    <name>arris::ui::AlarmHistory</name>
    <message>
        <source>Reading the alarm log…</source>
        <translation>Lettura del registro allarmi…</translation>
    </message>
    <message>
        <source>Alarms: %1</source>
        <translation>Allarmi: %1</translation>
    </message>
    <message>
        <source>Damaged lines of the alarm log, which cannot be read: %1</source>
        <translation>Righe danneggiate e illeggibili nel registro allarmi: %1</translation>
    </message>
</context>
<context>
    <name>arris::ui::AlarmModel</name>
    <message>
        <source>State</source>
        <translation>Stato</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Ora</translation>
    </message>
    <message>
        <source>Code, axis, value</source>
        <translation>Codice, asse, valore</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Evento</translation>
    </message>
</context>
<context>
    <name>arris::ui::AlarmPanel</name>
    <message>
        <source>Acknowledge</source>
        <translation>Conferma</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Tutti</translation>
    </message>
    <message>
        <source>Active</source>
        <translation>Attivi</translation>
    </message>
    <message>
        <source>Tap an alarm to read its cause and what to do.</source>
        <translation>Toccare un allarme per leggerne la causa e il rimedio.</translation>
    </message>
    <message>
        <source>No alarm is active.</source>
        <translation>Nessun allarme attivo.</translation>
    </message>
    <message>
        <source>There has been no alarm yet.</source>
        <translation>Finora non c&apos;è stato alcun allarme.</translation>
    </message>
</context>
<context>
    <name>arris::ui::AlarmTexts</name>
    <message>
        <source>active</source>
        <translation>attivo</translation>
    </message>
    <message>
        <source>acknowledged</source>
        <translation>confermato</translation>
    </message>
    <message>
        <source>not
acknowledged</source>
        <translation>non
confermato</translation>
    </message>
    <message>
        <source>Cause: %1</source>
        <translation>Causa: %1</translation>
    </message>
    <message>
        <source>What to do: %1</source>
        <translation>Rimedio: %1</translation>
    </message>
    <message>
        <source>Record of the run: %1</source>
        <translation>Registrazione del ciclo: %1</translation>
    </message>
</context>
<context>
    <name>arris::ui::AlarmsPage</name>
    <message>
        <source>Alarms</source>
        <translation>Allarmi</translation>
    </message>
    <message>
        <source>Inputs and outputs</source>
        <translation>Ingressi e uscite</translation>
    </message>
    <message>
        <source>Counters and back-up</source>
        <translation>Contatori e backup</translation>
    </message>
</context>
<context>
    <name>arris::ui::BackUpPanel</name>
    <message>
        <source>In the machine&apos;s life</source>
        <translation>Dalla messa in servizio</translation>
    </message>
    <message>
        <source>So far</source>
        <translation>Finora</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Ripristina</translation>
    </message>
    <message>
        <source>Keep as it is</source>
        <translation>Lascia così</translation>
    </message>
    <message>
        <source>Reading or writing</source>
        <translation>Lettura o scrittura</translation>
    </message>
    <message>
        <source>Settings, machine, recipes and counters</source>
        <translation>Opzioni, macchina, ricette e contatori</translation>
    </message>
    <message>
        <source>Back up…</source>
        <translation>Salva…</translation>
    </message>
    <message>
        <source>Saves all of them in one file.</source>
        <translation>Salva tutto in un unico file.</translation>
    </message>
    <message>
        <source>Restore…</source>
        <translation>Ripristina…</translation>
    </message>
    <message>
        <source>Brings them back from such a file: while nothing moves and no job is loaded.</source>
        <translation>Li ripristina da un file di questo tipo: a macchina ferma e senza lavoro caricato.</translation>
    </message>
    <message>
        <source>Support bundle…</source>
        <translation>Pacchetto di assistenza…</translation>
    </message>
    <message>
        <source>Saves them with the alarm log, the last runs and versions, for whoever helps.</source>
        <translation>Li salva con registro allarmi, ultime esecuzioni e versioni, per chi assiste.</translation>
    </message>
    <message>
        <source>Reading or writing…</source>
        <translation>Lettura o scrittura…</translation>
    </message>
    <message>
        <source>Archives (*.tar.gz);;All files (*)</source>
        <translation>Archivi (*.tar.gz);;Tutti i file (*)</translation>
    </message>
    <message>
        <source>Back up</source>
        <translation>Salva backup</translation>
    </message>
    <message>
        <source>Support bundle</source>
        <translation>Pacchetto di assistenza</translation>
    </message>
    <message>
        <source>Restore a back-up</source>
        <translation>Ripristina un backup</translation>
    </message>
</context>
<context>
    <name>arris::ui::BackUps</name>
    <message>
        <source>Saved: %1. It has what help needs; nothing is sent to anybody.</source>
        <translation>Salvato: %1. Contiene ciò che serve all&apos;assistenza; nulla viene inviato a nessuno.</translation>
    </message>
    <message>
        <source>There is nothing to back up yet: no settings, machine, recipes or counters have been kept so far.</source>
        <translation>Non c&apos;è ancora nulla da salvare: finora non sono stati memorizzati opzioni, macchina, ricette o contatori.</translation>
    </message>
    <message>
        <source>Saved: %1. Files in it: %2.</source>
        <translation>Salvato: %1. File contenuti: %2.</translation>
    </message>
    <message>
        <source>Restore the back-up of %1? Its files (%2) replace settings, machine, recipes and counters of the same names. What is there now is kept as a back-up.</source>
        <translation>Ripristinare il backup del %1? I suoi file (%2) sostituiscono opzioni, macchina, ricette e contatori con gli stessi nomi. Lo stato attuale viene conservato come backup.</translation>
    </message>
    <message>
        <source>Nothing was changed.</source>
        <translation>Non è stato modificato nulla.</translation>
    </message>
    <message>
        <source>What was there before is in %1.</source>
        <translation>Lo stato precedente si trova in %1.</translation>
    </message>
    <message>
        <source>Restored. Close Arris and start it again: then it takes effect.</source>
        <translation>Ripristinato. Chiudere e riavviare Arris: solo allora ha effetto.</translation>
    </message>
</context>
<context>
    <name>arris::ui::BusyRow</name>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
</context>
<context>
    <name>arris::ui::ByHandPanel</name>
    <message>
        <source>Origin of the table (G54)</source>
        <translation>Origine della tavola (G54)</translation>
    </message>
    <message>
        <source>Zero of the table in X</source>
        <translation>Zero della tavola in X</translation>
    </message>
    <message>
        <source>Zero of the table in Y</source>
        <translation>Zero della tavola in Y</translation>
    </message>
    <message>
        <source>Zero of the table in Z</source>
        <translation>Zero della tavola in Z</translation>
    </message>
    <message>
        <source>Set here</source>
        <translation>Fissa qui</translation>
    </message>
    <message>
        <source>The table&apos;s zero of %1 is where the wheel is</source>
        <translation>Lo zero %1 della tavola è dove si trova la mola</translation>
    </message>
    <message>
        <source>Set the typed origin</source>
        <translation>Imposta origine inserita</translation>
    </message>
    <message>
        <source>Support of the glass</source>
        <translation>Appoggio del vetro</translation>
    </message>
    <message>
        <source>Spindle and coolant by hand</source>
        <translation>Mandrino e refrigerante in manuale</translation>
    </message>
    <message>
        <source>Spindle speed by hand</source>
        <translation>Velocità mandrino in manuale</translation>
    </message>
    <message>
        <source>Spindle on</source>
        <translation>Accendi mandrino</translation>
    </message>
    <message>
        <source>Spindle off</source>
        <translation>Spegni mandrino</translation>
    </message>
    <message>
        <source>Coolant on</source>
        <translation>Apri refrigerante</translation>
    </message>
    <message>
        <source>Coolant off</source>
        <translation>Chiudi refrigerante</translation>
    </message>
    <message>
        <source>A pane was broken off: its origin stays until it has been ground or given up.</source>
        <translation>Una lastra è stata interrotta: la sua origine resta finché non è molata o abbandonata.</translation>
    </message>
    <message>
        <source>Where the zero of the table lies in machine coordinates. Whether the job still fits into the travel is checked at once.</source>
        <translation>Dove si trova lo zero della tavola in coordinate macchina. Si verifica subito se il lavoro rientra ancora nella corsa.</translation>
    </message>
    <message>
        <source>The origin can be set when the axes are homed and at rest.</source>
        <translation>L&apos;origine si può impostare quando gli assi sono azzerati e fermi.</translation>
    </message>
    <message>
        <source>No job is loaded: its recipe says how high the glass lies.</source>
        <translation>Nessun lavoro caricato: la sua ricetta indica a che altezza si trova il vetro.</translation>
    </message>
    <message>
        <source>Of the job that is loaded: the underside of the glass lies %1 mm above the table, the glass is %2 mm thick, and the middle of the wheel grinds at Z %3 mm.</source>
        <translation>Del lavoro caricato: la faccia inferiore del vetro è %1 mm sopra la tavola, il vetro è spesso %2 mm e il centro della mola lavora a Z %3 mm.</translation>
    </message>
</context>
<context>
    <name>arris::ui::ControlStrip</name>
    <message>
        <source>FEED
HOLD</source>
        <translation>PAUSA
AVANZ.</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>STOP</translation>
    </message>
    <message>
        <source>Lock
30 s</source>
        <translation>Blocca
30 s</translation>
    </message>
    <message>
        <source>Lock the screen for 30 s to wipe it</source>
        <translation>Blocca lo schermo per 30 s per pulirlo</translation>
    </message>
</context>
<context>
    <name>arris::ui::CornerCard</name>
    <message>
        <source>Tap a corner to see its figures.</source>
        <translation>Toccare uno spigolo per vederne i valori.</translation>
    </message>
    <message>
        <source>No corners.</source>
        <translation>Nessuno spigolo.</translation>
    </message>
    <message>
        <source>Corner %1: %2, %3</source>
        <translation>Spigolo %1: %2, %3</translation>
    </message>
    <message>
        <source>Speed v&lt;sub&gt;trans&lt;/sub&gt;</source>
        <translation>Velocità v&lt;sub&gt;trans&lt;/sub&gt;</translation>
    </message>
    <message>
        <source>%1 mm/s, %2</source>
        <translation>%1 mm/s, %2</translation>
    </message>
    <message>
        <source>Blending a, t&lt;sub&gt;m&lt;/sub&gt;</source>
        <translation>Transiz. a, t&lt;sub&gt;m&lt;/sub&gt;</translation>
    </message>
    <message>
        <source>%1 mm/s²; %2 s</source>
        <translation>%1 mm/s²; %2 s</translation>
    </message>
    <message>
        <source>Widest, leg ℓ</source>
        <translation>Distanza max, ℓ</translation>
    </message>
    <message>
        <source>Relief</source>
        <translation>Distacco</translation>
    </message>
    <message>
        <source>yes: lifts %1; needs %2 mm</source>
        <translation>sì: stacca %1; min. %2 mm</translation>
    </message>
    <message>
        <source>no: lifts %1; needs %2 mm</source>
        <translation>no: stacca %1; min. %2 mm</translation>
    </message>
    <message>
        <source>Radius of the roll</source>
        <translation>Raggio aggiramento</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Planned</source>
        <translation>Previsto</translation>
    </message>
    <message>
        <source>%1 mm/s; %2 s</source>
        <translation>%1 mm/s; %2 s</translation>
    </message>
    <message>
        <source>Slowing L&lt;sub&gt;d&lt;/sub&gt;, L&lt;sub&gt;a&lt;/sub&gt;</source>
        <translation>Rampe L&lt;sub&gt;d&lt;/sub&gt;, L&lt;sub&gt;a&lt;/sub&gt;</translation>
    </message>
    <message>
        <source>%1; %2 mm</source>
        <translation>%1; %2 mm</translation>
    </message>
    <message>
        <source>(contour %1)</source>
        <translation>(contorno %1)</translation>
    </message>
    <message>
        <source>Glass left</source>
        <translation>Resta vetro</translation>
    </message>
    <message>
        <source>%1 mm before the corner</source>
        <translation>%1 mm davanti allo spigolo</translation>
    </message>
    <message>
        <source>Not ground</source>
        <translation>Non molato</translation>
    </message>
    <message>
        <source>%1 mm of its edges</source>
        <translation>%1 mm dei lati</translation>
    </message>
    <message>
        <source>Distance between wheel and corner over time</source>
        <translation>Distanza tra mola e spigolo nel tempo</translation>
    </message>
</context>
<context>
    <name>arris::ui::CornerModel</name>
    <message>
        <source>#</source>
        <translation>#</translation>
    </message>
    <message>
        <source>Angle
β</source>
        <translation>Angolo
β</translation>
    </message>
    <message>
        <source>Treatment</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Speed
mm/s</source>
        <translation>Vel.
mm/s</translation>
    </message>
    <message>
        <source>Accel.
mm/s²</source>
        <translation>Acc.
mm/s²</translation>
    </message>
    <message>
        <source>Time
s</source>
        <translation>Tempo
s</translation>
    </message>
    <message>
        <source>Widest
mm</source>
        <translation>Dist.
mm</translation>
    </message>
    <message>
        <source>Relief
mm</source>
        <translation>Distacco
mm</translation>
    </message>
</context>
<context>
    <name>arris::ui::Diagnosis</name>
    <message>
        <source>Drive ready</source>
        <translation>Azionamento pronto</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>pronto</translation>
    </message>
    <message>
        <source>off</source>
        <translation>spento</translation>
    </message>
    <message>
        <source>pressed</source>
        <translation>premuto</translation>
    </message>
    <message>
        <source>released</source>
        <translation>rilasciato</translation>
    </message>
    <message>
        <source>%1 h</source>
        <translation>%1 h</translation>
    </message>
    <message>
        <source>hit</source>
        <translation>attivo</translation>
    </message>
    <message>
        <source>free</source>
        <translation>libero</translation>
    </message>
    <message>
        <source>on</source>
        <translation>acceso</translation>
    </message>
    <message>
        <source>Limit switch, low end</source>
        <translation>Finecorsa minimo</translation>
    </message>
    <message>
        <source>Limit switch, high end</source>
        <translation>Finecorsa massimo</translation>
    </message>
    <message>
        <source>Reference switch</source>
        <translation>Finecorsa di zero</translation>
    </message>
    <message>
        <source>Drive enable (output)</source>
        <translation>Abilit. azionam. (uscita)</translation>
    </message>
    <message>
        <source>Drive fault</source>
        <translation>Guasto azionam.</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>guasto</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nessuno</translation>
    </message>
    <message>
        <source>Encoder</source>
        <translation>Encoder</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>perso</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Following error, mm</source>
        <translation>Errore inseguimento, mm</translation>
    </message>
    <message>
        <source>At worst since the start, mm</source>
        <translation>Massimo dall&apos;avvio, mm</translation>
    </message>
    <message>
        <source>Emergency stop</source>
        <translation>Emergenza</translation>
    </message>
    <message>
        <source>tripped</source>
        <translation>scattata</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>Mandrino</translation>
    </message>
    <message>
        <source>at speed</source>
        <translation>a regime</translation>
    </message>
    <message>
        <source>not at speed</source>
        <translation>non a regime</translation>
    </message>
    <message>
        <source>Coolant</source>
        <translation>Refrigerante</translation>
    </message>
    <message>
        <source>flows</source>
        <translation>scorre</translation>
    </message>
    <message>
        <source>does not flow</source>
        <translation>non scorre</translation>
    </message>
    <message>
        <source>Vacuum</source>
        <translation>Vuoto</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>tiene</translation>
    </message>
    <message>
        <source>does not hold</source>
        <translation>non tiene</translation>
    </message>
    <message>
        <source>Button cycle start</source>
        <translation>Pulsante avvio ciclo</translation>
    </message>
    <message>
        <source>Button feed hold</source>
        <translation>Pulsante pausa avanz.</translation>
    </message>
    <message>
        <source>Button stop</source>
        <translation>Pulsante stop</translation>
    </message>
    <message>
        <source>Button jog enable</source>
        <translation>Pulsante consenso jog</translation>
    </message>
    <message>
        <source>Override selector</source>
        <translation>Selettore override</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 r/min</source>
        <translation>%1 giri/min</translation>
    </message>
    <message>
        <source>Heartbeat</source>
        <translation>Battito</translation>
    </message>
    <message>
        <source>beats</source>
        <translation>batte</translation>
    </message>
    <message>
        <source>stands still</source>
        <translation>fermo</translation>
    </message>
    <message>
        <source>Least lead, periods</source>
        <translation>Anticipo minimo, cicli</translation>
    </message>
    <message>
        <source>Late wake-ups</source>
        <translation>Risvegli tardivi</translation>
    </message>
    <message>
        <source>Latest wake-up, ms</source>
        <translation>Ritardo massimo, ms</translation>
    </message>
    <message>
        <source>Buffered pairs</source>
        <translation>Coppie nel buffer</translation>
    </message>
    <message>
        <source>Lost reports</source>
        <translation>Report persi</translation>
    </message>
    <message>
        <source>Refused commands</source>
        <translation>Comandi rifiutati</translation>
    </message>
    <message>
        <source>Drives on</source>
        <translation>Azionam. accesi</translation>
    </message>
    <message>
        <source>Spindle on</source>
        <translation>Mandrino acceso</translation>
    </message>
    <message>
        <source>Grinding</source>
        <translation>Molatura</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Molato</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Panes ground</source>
        <translation>Lastre molate</translation>
    </message>
    <message>
        <source>Counted since</source>
        <translation>Contato dal</translation>
    </message>
</context>
<context>
    <name>arris::ui::DiagnosisPanel</name>
    <message>
        <source>Axes</source>
        <translation>Assi</translation>
    </message>
    <message>
        <source>Controller</source>
        <translation>Controllo</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Ora</translation>
    </message>
    <message>
        <source>Inputs</source>
        <translation>Ingressi</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Uscite</translation>
    </message>
</context>
<context>
    <name>arris::ui::DrawingView</name>
    <message>
        <source>Drawing</source>
        <translation>Disegno</translation>
    </message>
    <message>
        <source>Open a pattern (DXF), or drop one here.</source>
        <translation>Aprire una sagoma (DXF) o trascinarla qui.</translation>
    </message>
</context>
<context>
    <name>arris::ui::FindingsPanel</name>
    <message>
        <source>Corners</source>
        <translation>Spigoli</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problemi</translation>
    </message>
    <message>
        <source>Times</source>
        <translation>Tempi</translation>
    </message>
    <message>
        <source>Problems (%1)</source>
        <translation>Problemi (%1)</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Dettagli</translation>
    </message>
</context>
<context>
    <name>arris::ui::HelpPage</name>
    <message>
        <source>Manual</source>
        <translation>Manuale d&apos;uso</translation>
    </message>
    <message>
        <source>en</source>
        <comment>language of the manual</comment>
        <extracomment>The language that the manual is read in: that of this translation, &quot;de&quot; or &quot;zh_CN&quot;.</extracomment>
        <translation>it</translation>
    </message>
</context>
<context>
    <name>arris::ui::JobPage</name>
    <message>
        <source>Drawing</source>
        <translation>Disegno</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>Profilo</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Entrambi</translation>
    </message>
    <message>
        <source>Planning</source>
        <translation>Calcolo in corso</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Riduci</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Ingrandisci</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Adatta</translation>
    </message>
    <message>
        <source>Fit into the view</source>
        <translation>Adatta alla vista</translation>
    </message>
    <message>
        <source>Reading and planning…</source>
        <translation>Lettura e calcolo in corso…</translation>
    </message>
    <message>
        <source>No pattern is open.</source>
        <translation>Nessuna sagoma aperta.</translation>
    </message>
    <message>
        <source>Cannot be ground: see the problems.</source>
        <translation>Non molabile: vedere i problemi.</translation>
    </message>
    <message>
        <source>Cancelled. Open a pattern.</source>
        <translation>Annullato. Aprire una sagoma.</translation>
    </message>
    <message>
        <source>Cancelled: no profile.
To plan: change a value.</source>
        <translation>Annullato: nessun profilo.
Calcolo: cambiare un valore.</translation>
    </message>
    <message>
        <source>Cancelled: values before.
To plan: change a value.</source>
        <translation>Annullato: valori di prima.
Calcolo: cambiare un valore.</translation>
    </message>
    <message>
        <source>Grinding: %1
Program: %2</source>
        <translation>Molatura: %1
Programma: %2</translation>
    </message>
</context>
<context>
    <name>arris::ui::Keypad</name>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
</context>
<context>
    <name>arris::ui::MainWindow</name>
    <message>
        <source>%1 – Arris</source>
        <translation>%1 – Arris</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Lavoro</translation>
    </message>
    <message>
        <source>Setup</source>
        <translation>Manuale</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ciclo</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Profili</translation>
    </message>
    <message>
        <source>The machine is moving</source>
        <translation>La macchina è in movimento</translation>
    </message>
    <message>
        <source>Stop the machine and close Arris? The job can be resumed later.</source>
        <translation>Arrestare la macchina e chiudere Arris? Il lavoro potrà essere ripreso più tardi.</translation>
    </message>
    <message>
        <source>Stop and close</source>
        <translation>Arresta e chiudi</translation>
    </message>
    <message>
        <source>Keep running</source>
        <translation>Continua il lavoro</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Allarmi</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Opzioni</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Guida</translation>
    </message>
</context>
<context>
    <name>arris::ui::NumberEdit</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>from %1 to %2</source>
        <translation>da %1 a %2</translation>
    </message>
    <message>
        <source>%1: type a number %2.</source>
        <translation>%1: inserire un numero %2.</translation>
    </message>
    <message>
        <source>%1: “%2” can mean %3 or %4; type it that way.</source>
        <translation>%1: «%2» può significare %3 o %4; scriverlo in quel modo.</translation>
    </message>
    <message>
        <source>%1 is not a number; type one %2.</source>
        <translation>%1: non è un numero; inserirne uno %2.</translation>
    </message>
    <message>
        <source>%1 is out of range; it must be %2.</source>
        <translation>%1: fuori dai limiti; inserire un valore %2.</translation>
    </message>
</context>
<context>
    <name>arris::ui::OrderPanel</name>
    <message>
        <source>Good</source>
        <translation>Buona</translation>
    </message>
    <message>
        <source>The pane is good</source>
        <translation>La lastra è buona</translation>
    </message>
    <message>
        <source>Reject</source>
        <translation>Scarto</translation>
    </message>
    <message>
        <source>The pane is a reject</source>
        <translation>La lastra è uno scarto</translation>
    </message>
    <message>
        <source>Fewer panes</source>
        <translation>Meno lastre</translation>
    </message>
    <message>
        <source>More panes</source>
        <translation>Più lastre</translation>
    </message>
    <message>
        <source>Grind the next pane smaller</source>
        <translation>Prossima lastra più piccola</translation>
    </message>
    <message>
        <source>Leave the next pane larger</source>
        <translation>Prossima lastra più grande</translation>
    </message>
    <message>
        <source>Size correction, next pane</source>
        <translation>Correzione, prossima lastra</translation>
    </message>
    <message>
        <source>More leaves the pane larger.</source>
        <translation>Un valore maggiore lascia la lastra più grande.</translation>
    </message>
    <message>
        <source>Pane %1 of %2: %3 good, %4 rejected</source>
        <translation>Lastra %1 di %2: %3 buone, %4 scarti</translation>
    </message>
    <message>
        <source>Load for the next pane</source>
        <translation>Carica per prossima lastra</translation>
    </message>
    <message>
        <source>Load job</source>
        <translation>Carica lavoro</translation>
    </message>
    <message>
        <source>The pane is interrupted: resume it, or stop it, before a job is loaded.</source>
        <translation>La lastra è sospesa: riprenderla o arrestarla prima di caricare un lavoro.</translation>
    </message>
    <message>
        <source>Values have changed; this pane stays as it was loaded. After it load the job for the next pane.</source>
        <translation>Valori modificati; questa lastra resta come è stata caricata. Dopo, caricare il lavoro per la prossima lastra.</translation>
    </message>
    <message>
        <source>Pane %1 has ended: good or reject? Changed since it was loaded: load the job again for the next pane.</source>
        <translation>Lastra %1 terminata: buona o scarto? Modificato dopo il caricamento: ricaricare per la prossima lastra.</translation>
    </message>
    <message>
        <source>Changed since it was loaded: load the job again for the next pane.</source>
        <translation>Modificato dopo il caricamento: ricaricare per la prossima lastra.</translation>
    </message>
    <message>
        <source>Pane %1 has ended: good or reject? It counts as good when the next one begins.</source>
        <translation>Lastra %1 terminata: buona o scarto? Vale come buona quando inizia la successiva.</translation>
    </message>
    <message>
        <source>The order is complete.</source>
        <translation>L&apos;ordine è completo.</translation>
    </message>
    <message>
        <source>The page Job shows other values than it has: nothing can be loaded before they are planned.</source>
        <translation>La pagina «Lavoro» mostra valori non ancora calcolati: finché non vengono calcolati non si può caricare nulla.</translation>
    </message>
    <message>
        <source>Panes</source>
        <translation>Lastre</translation>
    </message>
    <message>
        <source>What is planned on the page Job cannot be ground: nothing can be loaded before that is put right.</source>
        <translation>Quanto è previsto nella pagina «Lavoro» non si può molare: prima di correggerlo non si carica nulla.</translation>
    </message>
    <message>
        <source>Pane %1 was broken off. After the alarm CYCLE START goes on with it; “Reject”, or loading a job, gives it up.</source>
        <translation>Lastra %1 interrotta. Dopo l&apos;allarme AVVIO CICLO la prosegue; «Scarto» o il caricamento di un lavoro la abbandona.</translation>
    </message>
    <message>
        <source>Pane %1 was broken off: CYCLE START goes on with it. “Reject”, or loading a job, gives it up.</source>
        <translation>Lastra %1 interrotta: AVVIO CICLO la prosegue; «Scarto» o il caricamento di un lavoro la abbandona.</translation>
    </message>
</context>
<context>
    <name>arris::ui::PathPlot</name>
    <message>
        <source>X, mm</source>
        <translation>X, mm</translation>
    </message>
    <message>
        <source>Y, mm</source>
        <translation>Y, mm</translation>
    </message>
</context>
<context>
    <name>arris::ui::PatternDialog</name>
    <message>
        <source>Open pattern</source>
        <translation>Apri sagoma</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Recenti</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Esempi</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Cartella</translation>
    </message>
    <message>
        <source>Patterns</source>
        <translation>Sagome</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Su</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Apri</translation>
    </message>
    <message>
        <source>Here are neither drawings (*.dxf) nor folders.</source>
        <translation>Qui non ci sono né disegni (*.dxf) né cartelle.</translation>
    </message>
    <message>
        <source>No pattern was opened yet, or none is still there.</source>
        <translation>Nessuna sagoma aperta finora, o nessuna esiste più.</translation>
    </message>
</context>
<context>
    <name>arris::ui::PatternPanel</name>
    <message>
        <source>Reading</source>
        <translation>Lettura</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problemi</translation>
    </message>
    <message>
        <source>There is nothing to show.</source>
        <translation>Non c&apos;è nulla da mostrare.</translation>
    </message>
    <message>
        <source>Tap a pattern to see it.</source>
        <translation>Toccare una sagoma per vederla.</translation>
    </message>
    <message>
        <source>Unit of the drawing: %1, assumed</source>
        <translation>Unità del disegno: %1, presunta</translation>
    </message>
    <message>
        <source>Unit of the drawing: %1</source>
        <translation>Unità del disegno: %1</translation>
    </message>
</context>
<context>
    <name>arris::ui::PatternView</name>
    <message>
        <source>Drawing</source>
        <translation>Disegno</translation>
    </message>
</context>
<context>
    <name>arris::ui::ProblemModel</name>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1: %2 %3</translation>
    </message>
    <message>
        <source>Repaired</source>
        <translation>Riparato</translation>
    </message>
</context>
<context>
    <name>arris::ui::ProfilePlot</name>
    <message>
        <source>time, s</source>
        <translation>tempo, s</translation>
    </message>
    <message>
        <source>X velocity
mm/s</source>
        <translation>Velocità X
mm/s</translation>
    </message>
    <message>
        <source>v X
mm/s</source>
        <translation>v X
mm/s</translation>
    </message>
    <message>
        <source>Y velocity
mm/s</source>
        <translation>Velocità Y
mm/s</translation>
    </message>
    <message>
        <source>v Y
mm/s</source>
        <translation>v Y
mm/s</translation>
    </message>
    <message>
        <source>X acceleration
mm/s²</source>
        <translation>Acceler. X
mm/s²</translation>
    </message>
    <message>
        <source>a X
mm/s²</source>
        <translation>a X
mm/s²</translation>
    </message>
    <message>
        <source>Y acceleration
mm/s²</source>
        <translation>Acceler. Y
mm/s²</translation>
    </message>
    <message>
        <source>a Y
mm/s²</source>
        <translation>a Y
mm/s²</translation>
    </message>
    <message>
        <source>Path speed
mm/s</source>
        <translation>Vel. percorso
mm/s</translation>
    </message>
    <message>
        <source>v
mm/s</source>
        <translation>v
mm/s</translation>
    </message>
    <message>
        <source>Wheel to corner
mm</source>
        <translation>Mola–spigolo
mm</translation>
    </message>
    <message>
        <source>L
mm</source>
        <translation>L
mm</translation>
    </message>
    <message>
        <source>limit %1</source>
        <translation>limite %1</translation>
    </message>
    <message>
        <source>feed %1</source>
        <translation>avanz. %1</translation>
    </message>
    <message>
        <source>X position
mm</source>
        <translation>Posizione X
mm</translation>
    </message>
    <message>
        <source>X
mm</source>
        <translation>X
mm</translation>
    </message>
    <message>
        <source>Y position
mm</source>
        <translation>Posizione Y
mm</translation>
    </message>
    <message>
        <source>Y
mm</source>
        <translation>Y
mm</translation>
    </message>
    <message>
        <source>travel %1</source>
        <translation>corsa %1</translation>
    </message>
</context>
<context>
    <name>arris::ui::ProfilesPage</name>
    <message>
        <source>Open…</source>
        <translation>Apri…</translation>
    </message>
    <message>
        <source>Open an exported profile or the record of a run</source>
        <translation>Apre un profilo esportato o la registrazione di un&apos;esecuzione</translation>
    </message>
    <message>
        <source>Planned</source>
        <translation>Previsto</translation>
    </message>
    <message>
        <source>Back to the planned profile alone</source>
        <translation>Torna al solo profilo previsto</translation>
    </message>
    <message>
        <source>Over the plan</source>
        <translation>Sul previsto</translation>
    </message>
    <message>
        <source>Show the plan under the open file</source>
        <translation>Mostra il previsto sotto il file aperto</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>Immagine…</translation>
    </message>
    <message>
        <source>Save a picture as SVG, PNG or PDF</source>
        <translation>Salva un&apos;immagine come SVG, PNG o PDF</translation>
    </message>
    <message>
        <source>Previous corner</source>
        <translation>Spigolo precedente</translation>
    </message>
    <message>
        <source>Next corner</source>
        <translation>Spigolo successivo</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Riduci</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Ingrandisci</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Molatura</translation>
    </message>
    <message>
        <source>From the first lead-in to the last lead-out</source>
        <translation>Dal primo attacco all&apos;ultima uscita</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Tutto</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Lettura</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Previsto</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Reading or writing…</source>
        <translation>Lettura o scrittura…</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Salvato: %1</translation>
    </message>
    <message>
        <source>%1, drawn thin over the plan, which is wide and pale</source>
        <translation>%1, con linea sottile sul previsto, largo e chiaro</translation>
    </message>
    <message>
        <source>Planned: %1</source>
        <translation>Previsto: %1</translation>
    </message>
    <message>
        <source>Planning…</source>
        <translation>Calcolo in corso…</translation>
    </message>
    <message>
        <source>The pattern cannot be ground: there is no planned profile.</source>
        <translation>La sagoma non è molabile: non c&apos;è un profilo previsto.</translation>
    </message>
    <message>
        <source>No pattern is open. Profiles and records of runs can be opened all the same.</source>
        <translation>Nessuna sagoma aperta. Profili e registrazioni si possono aprire comunque.</translation>
    </message>
    <message>
        <source>Open profile or record</source>
        <translation>Apri profilo o registrazione</translation>
    </message>
    <message>
        <source>Records and profiles (*.arrisrun *.csv *.CSV);;All files (*)</source>
        <translation>Registrazioni e profili (*.arrisrun *.csv *.CSV);;Tutti i file (*)</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Salva immagine</translation>
    </message>
    <message>
        <source>Profile…</source>
        <translation>Profilo…</translation>
    </message>
    <message>
        <source>Save the profile as a table (CSV)</source>
        <translation>Salva il profilo come tabella (CSV)</translation>
    </message>
    <message>
        <source>Job sheet…</source>
        <translation>Scheda…</translation>
    </message>
    <message>
        <source>Save drawing, values, corners and times of the job as PDF</source>
        <translation>Salva disegno, valori, spigoli e tempi del lavoro come PDF</translation>
    </message>
    <message>
        <source>Speeds</source>
        <translation>Velocità</translation>
    </message>
    <message>
        <source>Velocities, accelerations and distance to the corner over time</source>
        <translation>Velocità, accelerazioni e distanza dallo spigolo nel tempo</translation>
    </message>
    <message>
        <source>Positions</source>
        <translation>Posizioni</translation>
    </message>
    <message>
        <source>X and Y over time</source>
        <translation>X e Y nel tempo</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Percorso</translation>
    </message>
    <message>
        <source>The way of the wheel in the plane</source>
        <translation>Il percorso della mola nel piano</translation>
    </message>
    <message>
        <source>From the start of the program to its end; of the path: all of the travel</source>
        <translation>Dall&apos;inizio del programma alla sua fine; per il percorso: tutta la corsa</translation>
    </message>
    <message>
        <source>%1, corner %2</source>
        <translation>%1, spigolo %2</translation>
    </message>
    <message>
        <source>Save the profile of the run %1</source>
        <translation>Salva il profilo dell&apos;esecuzione %1</translation>
    </message>
    <message>
        <source>Save the planned profile</source>
        <translation>Salva il profilo previsto</translation>
    </message>
    <message>
        <source>Save job sheet</source>
        <translation>Salva scheda lavoro</translation>
    </message>
</context>
<context>
    <name>arris::ui::RecipeBook</name>
    <message>
        <source>%1, wheel R %2</source>
        <translation>%1, mola R %2</translation>
    </message>
</context>
<context>
    <name>arris::ui::RecipeDialog</name>
    <message>
        <source>Recipes (*.json);;All files (*)</source>
        <translation>Ricette (*.json);;Tutti i file (*)</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Carica</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Elimina</translation>
    </message>
    <message>
        <source>Import…</source>
        <translation>Importa…</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Esporta…</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Salva</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Sì</translation>
    </message>
    <message>
        <source>No</source>
        <translation>No</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Ricette</translation>
    </message>
    <message>
        <source>All recipes</source>
        <translation>Tutte le ricette</translation>
    </message>
    <message>
        <source>For the glass thickness set now</source>
        <translation>Per lo spessore vetro impostato</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Chiudi</translation>
    </message>
    <message>
        <source>Save the values in effect as</source>
        <translation>Salva i valori attivi come</translation>
    </message>
    <message>
        <source>“%1” is in effect.</source>
        <translation>«%1» è attiva.</translation>
    </message>
    <message>
        <source>Saved as “%1”.</source>
        <translation>Salvata come «%1».</translation>
    </message>
    <message>
        <source>Replace “%1” by the values in effect?</source>
        <translation>Sostituire «%1» con i valori attivi?</translation>
    </message>
    <message>
        <source>Delete “%1”?</source>
        <translation>Eliminare «%1»?</translation>
    </message>
    <message>
        <source>“%1” is deleted.</source>
        <translation>«%1» è stata eliminata.</translation>
    </message>
    <message>
        <source>Import a recipe</source>
        <translation>Importa ricetta</translation>
    </message>
    <message>
        <source>Imported as “%1”; it is not in effect yet.</source>
        <translation>Importata come «%1»; non è ancora attiva.</translation>
    </message>
    <message>
        <source>Replace “%1” by the file?</source>
        <translation>Sostituire «%1» con il file?</translation>
    </message>
    <message>
        <source>Export a recipe</source>
        <translation>Esporta ricetta</translation>
    </message>
    <message>
        <source>“%1” is written to %2.</source>
        <translation>«%1» è stata salvata in %2.</translation>
    </message>
    <message>
        <source>No recipe has been saved yet.</source>
        <translation>Nessuna ricetta è stata ancora salvata.</translation>
    </message>
    <message>
        <source>No recipe is for this thickness of glass.</source>
        <translation>Nessuna ricetta è per questo spessore del vetro.</translation>
    </message>
</context>
<context>
    <name>arris::ui::RecipeFields</name>
    <message>
        <source>Heights</source>
        <translation>Quote</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>Spigoli</translation>
    </message>
    <message>
        <source>On the table</source>
        <translation>Sulla tavola</translation>
    </message>
    <message>
        <source>Lower left corner of the pane</source>
        <translation>In basso a sinistra della lastra</translation>
    </message>
    <message>
        <source>Centred on the table</source>
        <translation>Al centro della tavola</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Inizio</translation>
    </message>
    <message>
        <source>Start near this place</source>
        <translation>Inizio più vicino a</translation>
    </message>
    <message>
        <source>Left to Arris</source>
        <translation>A scelta di Arris</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Disegno</translation>
    </message>
    <message>
        <source>as the file says</source>
        <translation>come da file</translation>
    </message>
    <message>
        <source>Leave unground what
the wheel cannot reach</source>
        <translation>Non molare dove la
mola non arriva</translation>
    </message>
    <message>
        <source>Only these layers (none chosen: all)</source>
        <translation>Solo questi layer (nessuno scelto: tutti)</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Layer</translation>
    </message>
    <message>
        <source>Rim speed: %1 m/s</source>
        <translation>Vel. periferica: %1 m/s</translation>
    </message>
    <message>
        <source>The drawing still shows the last valid values.</source>
        <translation>Il disegno mostra ancora gli ultimi valori validi.</translation>
    </message>
</context>
<context>
    <name>arris::ui::RecipeModel</name>
    <message>
        <source>Name</source>
        <translation>Nome</translation>
    </message>
    <message>
        <source>Glass
mm</source>
        <translation>Vetro
mm</translation>
    </message>
    <message>
        <source>Wheel
mm</source>
        <translation>Mola
mm</translation>
    </message>
    <message>
        <source>Depth
mm</source>
        <translation>Prof.
mm</translation>
    </message>
    <message>
        <source>Feed
mm/min</source>
        <translation>Avanz.
mm/min</translation>
    </message>
</context>
<context>
    <name>arris::ui::RecipePanel</name>
    <message>
        <source>No pattern yet</source>
        <translation>Ancora nessuna sagoma</translation>
    </message>
    <message>
        <source>Grinding</source>
        <translation>Molatura</translation>
    </message>
    <message>
        <source>Pane</source>
        <translation>Lastra</translation>
    </message>
    <message>
        <source>&amp;Pattern…</source>
        <translation>&amp;Sagoma…</translation>
    </message>
    <message>
        <source>&amp;Recipes…</source>
        <translation>&amp;Ricette…</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annulla modifica</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Ripeti modifica</translation>
    </message>
    <message>
        <source>More values</source>
        <translation>Altri valori</translation>
    </message>
    <message>
        <source>Page before</source>
        <translation>Pagina precedente</translation>
    </message>
    <message>
        <source>Next page</source>
        <translation>Pagina successiva</translation>
    </message>
    <message>
        <source>Unnamed recipe</source>
        <translation>Senza nome</translation>
    </message>
    <message>
        <source>%1, changed</source>
        <translation>%1, modificata</translation>
    </message>
</context>
<context>
    <name>arris::ui::ReliefPlot</name>
    <message>
        <source>time from A, s</source>
        <translation>tempo da A, s</translation>
    </message>
    <message>
        <source>distance L, mm</source>
        <translation>distanza L, mm</translation>
    </message>
    <message>
        <source>relief
%1 mm</source>
        <translation>distacco
%1 mm</translation>
    </message>
</context>
<context>
    <name>arris::ui::ResumeBar</name>
    <message>
        <source>a power failure, or Arris ended</source>
        <translation>mancanza di corrente o chiusura di Arris</translation>
    </message>
    <message>
        <source>Arris ended in a hold</source>
        <translation>Arris chiuso durante una pausa</translation>
    </message>
    <message>
        <source>a stop</source>
        <translation>stop</translation>
    </message>
    <message>
        <source>a fault</source>
        <translation>guasto</translation>
    </message>
    <message>
        <source>the emergency stop</source>
        <translation>arresto di emergenza</translation>
    </message>
    <message>
        <source>its end from the terminal</source>
        <translation>chiusura dal terminale</translation>
    </message>
    <message>
        <source>Resume the job of %1: %2, pane %3 of %4, interrupted by %5?</source>
        <translation>Riprendere il lavoro del %1: %2, lastra %3 di %4 (interruzione: %5)?</translation>
    </message>
    <message>
        <source>Take it up</source>
        <translation>Riprendi</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Elimina</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Mantieni</translation>
    </message>
    <message>
        <source>Understood</source>
        <translation>Ho capito</translation>
    </message>
    <message>
        <source>Discard it for good</source>
        <translation>Elimina per sempre</translation>
    </message>
    <message>
        <source>The job that was broken off is being read and planned…</source>
        <translation>Lettura e calcolo del lavoro interrotto in corso…</translation>
    </message>
    <message>
        <source>Discard the job that was broken off? It cannot be resumed then.</source>
        <translation>Eliminare il lavoro interrotto? Non potrà più essere ripreso.</translation>
    </message>
    <message>
        <source>The job that was broken off cannot be resumed.</source>
        <translation>Il lavoro interrotto non può essere ripreso.</translation>
    </message>
    <message>
        <source>The job that was broken off is not resumed; what is known of it is kept as %1.</source>
        <translation>Il lavoro interrotto non viene ripreso; i dati noti sono conservati come %1.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annulla</translation>
    </message>
</context>
<context>
    <name>arris::ui::RunPage</name>
    <message>
        <source>Progress</source>
        <translation>Progresso</translation>
    </message>
    <message>
        <source>Feed override</source>
        <translation>Override avanz.</translation>
    </message>
    <message>
        <source>Lower feed override</source>
        <translation>Riduci override avanzamento</translation>
    </message>
    <message>
        <source>Higher feed override</source>
        <translation>Aumenta override avanzamento</translation>
    </message>
    <message>
        <source>◀ Back</source>
        <translation>◀ Passo indietro</translation>
    </message>
    <message>
        <source>RESUME</source>
        <translation>RIPRENDI</translation>
    </message>
    <message>
        <source>Keep it pressed until the ring is full.</source>
        <translation>Tenere premuto finché l&apos;anello è pieno.</translation>
    </message>
    <message>
        <source>CYCLE START
where it was broken off</source>
        <translation>AVVIO CICLO
dal punto interrotto</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tavola</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Macchina</translation>
    </message>
    <message>
        <source>To go</source>
        <translation>Residuo</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocità</translation>
    </message>
    <message>
        <source>To go: to the end of the line or arc that the wheel is on.</source>
        <translation>Residuo: fino alla fine della linea o dell&apos;arco su cui si trova la mola.</translation>
    </message>
    <message>
        <source>%1 of %2 mm/min</source>
        <translation>%1 di %2 mm/min</translation>
    </message>
    <message>
        <source>%1 mm/min</source>
        <translation>%1 mm/min</translation>
    </message>
    <message>
        <source>Open a pattern on the page Job, or drop one here.</source>
        <translation>Aprire una sagoma nella pagina «Lavoro» o trascinarla qui.</translation>
    </message>
    <message>
        <source>Forward ▶</source>
        <translation>Passo avanti ▶</translation>
    </message>
    <message>
        <source>CYCLE START
keep pressed</source>
        <translation>AVVIO CICLO
tenere premuto</translation>
    </message>
    <message>
        <source>Done: %1 %
To grind: %2 mm
Time left: %3</source>
        <translation>Fatto: %1 %
Da molare: %2 mm
Tempo residuo: %3</translation>
    </message>
</context>
<context>
    <name>arris::ui::SettingsPage</name>
    <message>
        <source>Set this code</source>
        <translation>Imposta codice</translation>
    </message>
    <message>
        <source>Take the code away</source>
        <translation>Rimuovi codice</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Finestra</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Macchina</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Codice</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Lingua</translation>
    </message>
    <message>
        <source>That of the system</source>
        <translation>Quella del sistema</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Scala</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Lunghezze</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>pollici</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Aspetto</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Chiaro</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Scuro</translation>
    </message>
    <message>
        <source>Keypad on the screen</source>
        <translation>Tastierino sullo schermo</translation>
    </message>
    <message>
        <source>At a touch</source>
        <translation>Al tocco</translation>
    </message>
    <message>
        <source>At a click too</source>
        <translation>Anche al clic</translation>
    </message>
    <message>
        <source>Scale, from the next start</source>
        <translation>Scala, dal prossimo avvio</translation>
    </message>
    <message>
        <source>What is changed here counts from the next start of Arris.</source>
        <translation>Le modifiche fatte qui valgono dal prossimo avvio di Arris.</translation>
    </message>
    <message>
        <source>A code protects the machine&apos;s values and, in the recipe, the accelerations. The operator&apos;s values stay open.</source>
        <translation>Un codice protegge i valori della macchina e, nella ricetta, le accelerazioni. I valori dell&apos;operatore restano aperti.</translation>
    </message>
    <message>
        <source>This is not the code.</source>
        <translation>Questo non è il codice.</translation>
    </message>
    <message>
        <source>A code has %1 to %2 digits.</source>
        <translation>Un codice ha da %1 a %2 cifre.</translation>
    </message>
    <message>
        <source>No code is set: all values are open.</source>
        <translation>Nessun codice impostato: tutti i valori sono aperti.</translation>
    </message>
    <message>
        <source>All values are open until they are locked or Arris starts again.</source>
        <translation>Tutti i valori sono aperti finché non vengono bloccati o Arris viene riavviato.</translation>
    </message>
    <message>
        <source>Locked: enter the code to change the machine.</source>
        <translation>Bloccato: inserire il codice per modificare la macchina.</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Assi</translation>
    </message>
    <message>
        <source>Simulated</source>
        <translation>Simulati</translation>
    </message>
    <message>
        <source>LinuxCNC</source>
        <translation>LinuxCNC</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Sblocca</translation>
    </message>
    <message>
        <source>Lock the values now</source>
        <translation>Proteggi ora i valori</translation>
    </message>
</context>
<context>
    <name>arris::ui::SetupPage</name>
    <message>
        <source>Drives</source>
        <translation>Azionamenti</translation>
    </message>
    <message>
        <source>Switch drives on</source>
        <translation>Accendi azionamenti</translation>
    </message>
    <message>
        <source>Home all axes</source>
        <translation>Azzera tutti gli assi</translation>
    </message>
    <message>
        <source>Switch drives off</source>
        <translation>Spegni azionamenti</translation>
    </message>
    <message>
        <source>Ways above the glass</source>
        <translation>Spostamenti sopra il vetro</translation>
    </message>
    <message>
        <source>Trace the outline at height</source>
        <translation>Segui il contorno in quota</translation>
    </message>
    <message>
        <source>Go to the park position</source>
        <translation>Vai al parcheggio</translation>
    </message>
    <message>
        <source>Fast</source>
        <translation>Rapido</translation>
    </message>
    <message>
        <source>Simulated machine</source>
        <translation>Macchina simulata</translation>
    </message>
    <message>
        <source>Next: switch the drives on.</source>
        <translation>Ora: accendere gli azionamenti.</translation>
    </message>
    <message>
        <source>Next: home all axes, so that their places are known.</source>
        <translation>Ora: azzerare tutti gli assi, affinché le loro posizioni siano note.</translation>
    </message>
    <message>
        <source>Next: load the job on the page Run.</source>
        <translation>Ora: caricare il lavoro nella pagina «Ciclo».</translation>
    </message>
    <message>
        <source>Ready for the cycle start on the page Run.</source>
        <translation>Pronta per l&apos;avvio ciclo nella pagina «Ciclo».</translation>
    </message>
    <message>
        <source>X %1   Y %2   Z %3 mm</source>
        <translation>X %1   Y %2   Z %3 mm</translation>
    </message>
    <message>
        <source>The places are not known yet.</source>
        <translation>Le posizioni non sono ancora note.</translation>
    </message>
    <message>
        <source>Drives and jog</source>
        <translation>Azionamenti e jog</translation>
    </message>
    <message>
        <source>Origin and by hand</source>
        <translation>Origine e manuale</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Simulazione</translation>
    </message>
    <message>
        <source>Jog</source>
        <translation>Jog</translation>
    </message>
    <message>
        <source>Continuous</source>
        <translation>Continuo</translation>
    </message>
    <message>
        <source>Jog as long as a button is pressed</source>
        <translation>Jog finché un pulsante è premuto</translation>
    </message>
    <message>
        <source>Jog by %1 mm</source>
        <translation>Jog di %1 mm</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Jog enable on the panel held</source>
        <translation>Consenso jog premuto sul pannello</translation>
    </message>
    <message>
        <source>Press the jog enable on the panel and keep it pressed: without it no axis is jogged.</source>
        <translation>Premere il consenso jog sul pannello e tenerlo premuto: senza di esso nessun asse si muove in jog.</translation>
    </message>
    <message>
        <source>An axis moves as long as its button is pressed.</source>
        <translation>Un asse si muove finché il suo pulsante è premuto.</translation>
    </message>
    <message>
        <source>Each press moves an axis by %1 mm.</source>
        <translation>Ogni pressione muove un asse di %1 mm.</translation>
    </message>
    <message>
        <source>Nothing can be moved: %1</source>
        <translation>Non si può muovere nulla: %1</translation>
    </message>
    <message>
        <source>Clear all faults</source>
        <translation>Elimina tutti i guasti</translation>
    </message>
    <message>
        <source>Read the alarm above, remove its cause, acknowledge it.</source>
        <translation>Leggere l&apos;allarme in alto, eliminarne la causa, confermarlo.</translation>
    </message>
    <message>
        <source>Held: go on with RESUME on the page Run, or STOP.</source>
        <translation>In pausa: premere RIPRENDI nella pagina «Ciclo», oppure STOP.</translation>
    </message>
    <message>
        <source>Something moves: until it ends nothing is moved from here.</source>
        <translation>Qualcosa si muove: finché non termina, da qui non si muove nulla.</translation>
    </message>
</context>
<context>
    <name>arris::ui::TimeModel</name>
    <message>
        <source>Grinding, lead-in to lead-out</source>
        <translation>Molatura, da attacco a uscita</translation>
    </message>
    <message>
        <source>Whole program</source>
        <translation>Intero programma</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Fase</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Quota</translation>
    </message>
</context>
<context>
    <name>arris::ui::WheelBar</name>
    <message>
        <source>Wheel back along its path</source>
        <translation>Mola indietro sul suo percorso</translation>
    </message>
    <message>
        <source>Wheel on along its path</source>
        <translation>Mola avanti sul suo percorso</translation>
    </message>
</context>
<context>
    <name>arris::ui::WipeCover</name>
    <message>
        <source>The screen is locked for wiping: %1 s
FEED HOLD and STOP work whenever something moves.</source>
        <translation>Lo schermo è bloccato per la pulizia: %1 s
PAUSA AVANZ. e STOP funzionano ogni volta che qualcosa si muove.</translation>
    </message>
</context>
</TS>
